# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line above the rows of the results panel: the filter and the panel's menus."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from vkworkbench.core import Strategy
from vkworkbench.gui.qt.names import MenuButton, QCheckBox, QComboBox, QHBoxLayout, QLineEdit, QMenu, QWidget
from vkworkbench.gui.qt.sentences import strategy_name
from vkworkbench.gui.qt.text import explain, translate


class Filter(QWidget):
    """Lets the user filter the rows of the results panel by text, by strategy and by warnings."""

    def __init__(self, menus: Sequence[QMenu]) -> None:
        super().__init__()
        self.changed: Callable[[], None] = lambda: None  # called after each change of the filter
        self.words = QLineEdit()
        self.words.setPlaceholderText(translate("Vk_Results", "Filter"))
        explain(
            self.words,
            translate("Vk_Results", "Shows operations that contain this text in their name, strategy or warnings."),
        )
        self.words.setClearButtonEnabled(True)
        self.words.setMinimumWidth(80)
        self.words.textChanged.connect(lambda text: self.changed())
        self.strategies = QComboBox()
        explain(self.strategies, translate("Vk_Results", "Shows operations with this strategy."))
        self.strategies.setSizeAdjustPolicy(QComboBox.AdjustToContents)
        self.strategies.currentIndexChanged.connect(lambda number: self.changed())
        self.warnings = QCheckBox(translate("Vk_Results", "&Warnings Only"))
        self.warnings.setToolTip(translate("Vk_Results", "Shows operations that have warnings or are outdated."))
        self.warnings.toggled.connect(lambda on: self.changed())
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        for widget in (self.words, self.strategies, self.warnings):
            row.addWidget(widget)
        row.addStretch()
        for menu in menus:
            row.addWidget(MenuButton(menu.title(), menu))
        self.offer(set())

    @property
    def text(self) -> str:
        return self.words.text().strip()

    @property
    def strategy(self) -> Strategy | None:
        """The chosen strategy; None for all strategies."""
        chosen = self.strategies.currentData()
        return Strategy(chosen) if chosen else None

    @property
    def warned(self) -> bool:
        return self.warnings.isChecked()

    def offer(self, present: set[Strategy]) -> None:
        """Offer the strategies that are present in the results, and the strategy that is chosen already."""
        chosen = self.strategy
        offered = [strategy for strategy in Strategy if strategy in present or strategy is chosen]
        listed = [self.strategies.itemData(i) for i in range(self.strategies.count())]
        if listed == ["", *(strategy.value for strategy in offered)]:
            return
        self.strategies.blockSignals(True)
        self.strategies.clear()
        self.strategies.addItem(translate("Vk_Results", "All Strategies"), "")
        for strategy in offered:
            self.strategies.addItem(strategy_name(strategy), strategy.value)
        self.strategies.setCurrentIndex(1 + offered.index(chosen) if chosen else 0)
        self.strategies.blockSignals(False)
