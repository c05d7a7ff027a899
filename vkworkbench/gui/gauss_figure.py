# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of the method: toolpath, Gauss map and angular functions of one area, with matplotlib.

Its words are the paper's symbols, the same in all languages: matplotlib's font has no Chinese. Loads matplotlib.
"""

from __future__ import annotations

import matplotlib
import numpy as np
from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from matplotlib.gridspec import GridSpec
from matplotlib.ticker import FuncFormatter, MaxNLocator, MultipleLocator

from vkworkbench.core.paper import Areas, image_arcs, links, outline, seen, thinned, turns_of
from vkworkbench.gui.qt import QTimer
from vkworkbench.gui.sentences import user

COUNTER_CLOCKWISE, CLOCKWISE = "#0072b2", "#d55e00"  # told apart also by the colour-blind
_V, _LEVEL = "#009e73", "#9a9a9a"  # V_k and its angle; levels and the rest of the toolpath
TRAIL = 1000  # trajectories up to k that are drawn strongly and on the Gauss map
_COLUMNS = 1000  # stretches of the graph, see thinned()
_MARKERS = 500
_WIDE = 1.8  # width over height from which the three plots stand in a row
_GROWTH = 0.5  # how much the arcs' radius grows or shrinks along the trail


class GaussCanvas(FigureCanvasQTAgg):
    """A widget with the three plots of one area; `step` moves through its trajectories.

    What changes with the step is drawn over a stored picture of the rest, so that the slider responds at once.
    """

    def __init__(self) -> None:
        super().__init__(Figure(layout="constrained"))
        self._text, self._back = "black", "white"
        self._areas: Areas | None = None
        self._moving: list = []
        self._still = None
        self._k = 0
        self.points, self.drawn = 0, 0  # points of the polyline, and those of them that the picture has
        # Matplotlib's own timer for drawing later never fires again in FreeCAD 1.0 once an SVG was saved.
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.timeout.connect(self.draw)
        self.mpl_connect("draw_event", lambda event: self._drawn())

    def set_colors(self, text: str, background: str) -> None:
        """Take the window's colours for what is drawn next."""
        self._text, self._back = text, background

    def show_area(self, areas: Areas, area: int) -> None:
        """Draw one area and the others around it, at its last trajectory."""
        self._areas = areas
        self.signature = areas.signature(area)
        self.vertices = self.signature.vertices
        self._k = len(self.signature) - 1
        self._lay_out()

    def step(self, k: int) -> None:
        """Show the state after trajectory `k`, counted from 0."""
        self._k = k
        self._move()
        if self._still is None:
            self.draw_idle()
            return
        self.restore_region(self._still)
        self._draw_moving()
        self.update()

    def save(self, path: str) -> None:
        """Write the picture as it stands; the suffix says the format."""
        for artist in self._moving:
            artist.set_animated(False)
        try:
            with matplotlib.rc_context({"svg.fonttype": "none", "agg.path.chunksize": 10_000}):
                self.figure.savefig(path, dpi=200)
        finally:
            for artist in self._moving:
                artist.set_animated(True)
            self._still = None
            self.draw_idle()

    def draw(self) -> None:
        # Without this a long polyline may exceed what the renderer holds.
        with matplotlib.rc_context({"agg.path.chunksize": 10_000}):
            super().draw()

    def draw_idle(self) -> None:
        self._later.start(0)

    def resizeEvent(self, event) -> None:
        self._still = None
        super().resizeEvent(event)
        if self._areas is not None and self._is_wide() != self._wide:
            self._lay_out()

    def _is_wide(self) -> bool:
        return self.width() > _WIDE * self.height()

    def _lay_out(self) -> None:
        figure = self.figure
        figure.clear()
        figure.set_facecolor(self._back)
        self._wide = self._is_wide()
        if self._wide:
            grid = GridSpec(1, 3, figure, width_ratios=(1, 1, 1.5))
            path, circle, graph = (figure.add_subplot(cell) for cell in grid)
        else:
            grid = GridSpec(2, 2, figure)
            path, circle = figure.add_subplot(grid[0, 0]), figure.add_subplot(grid[0, 1])
            graph = figure.add_subplot(grid[1, :])
        for axes in (path, circle, graph):
            axes.set_facecolor(self._back)
            axes.tick_params(colors=self._text, labelsize="small")
            axes.title.set_color(self._text)
            for spine in axes.spines.values():
                spine.set_color(_LEVEL)
        self._moving = []
        self._draw_path(path)
        self._draw_circle(circle)
        self._draw_graph(graph)
        for artist in self._moving:
            artist.set_animated(True)
        self._move()
        self._still = None
        self.draw_idle()

    def _draw_path(self, axes) -> None:
        polyline, between = outline(self._areas), links(self._areas)
        shown = seen(polyline)
        self.points, self.drawn = len(polyline), len(shown)
        axes.plot(*polyline[shown].T, color=_LEVEL, linewidth=0.6)
        if len(between):
            axes.plot(*between[seen(between)].T, color=_LEVEL, linewidth=0.6, linestyle=":")
        axes.plot(*self.vertices[seen(self.vertices)].T, color=self._text, linewidth=0.9)
        axes.plot(*self.vertices[0], "o", color=self._text, markersize=4)
        axes.set_aspect("equal", adjustable="datalim")
        _label_lengths(axes, float(np.ptp(self.vertices, axis=0).max()), self._text)
        (self._trail,) = axes.plot([], [], color=COUNTER_CLOCKWISE, linewidth=1.4)
        self._v = axes.annotate(
            "", (0, 0), (0, 0), arrowprops={"arrowstyle": "-|>", "color": _V, "linewidth": 1.6,
                                            "shrinkA": 0, "shrinkB": 0},
        )  # fmt: skip
        self._v_name = axes.annotate("$V_k$", (0, 0), (6, 6), textcoords="offset points", color=_V)
        self._moving += [self._trail, self._v, self._v_name]

    def _draw_circle(self, axes) -> None:
        round_ = np.linspace(0, 2 * np.pi, 181)
        axes.plot(np.cos(round_), np.sin(round_), color=self._text, linewidth=0.9)
        axes.axhline(0, color=_LEVEL, linewidth=0.4)
        axes.axvline(0, color=_LEVEL, linewidth=0.4)
        size = 1.1 + _GROWTH
        axes.set_aspect("equal")
        axes.set_xlim(-size, size)
        axes.set_ylim(-size, size)
        axes.set_xticks([])
        axes.set_yticks([])
        for spine in axes.spines.values():
            spine.set_visible(False)
        for at, x, color, name in ((1, 0.02, COUNTER_CLOCKWISE, "↺"), (1, 0.12, CLOCKWISE, "↻")):
            axes.text(x, at, name, color=color, transform=axes.transAxes, va="top", fontsize="x-large")
        self._arcs = []
        for width in (1.2, 1.2):  # of the directions, and of V_k
            for color in (COUNTER_CLOCKWISE, CLOCKWISE):
                self._arcs += axes.plot([], [], color=color, linewidth=width)
        (self._half_turns,) = axes.plot([], [], "x", color=self._text, markersize=5)
        (self._ray,) = axes.plot([], [], color=self._text, linewidth=1)
        (self._v_ray,) = axes.plot([], [], color=_V, linewidth=1.6)
        (self._image,) = axes.plot([], [], "o", color=self._text, markersize=6)
        (self._v_image,) = axes.plot([], [], "o", color=_V, markersize=6)
        in_a_box = {"ha": "center", "va": "center", "bbox": {"facecolor": self._back, "linewidth": 0, "pad": 0.5}}
        self._image_name = axes.text(0, 0, "$v_k$", color=self._text, **in_a_box)
        self._v_image_name = axes.text(0, 0, "$V_k$", color=_V, **in_a_box)
        self._moving += [
            *self._arcs, self._half_turns, self._ray, self._v_ray, self._image, self._v_image, self._image_name,
            self._v_image_name,
        ]  # fmt: skip

    def _draw_graph(self, axes) -> None:
        signature = self.signature
        k = np.arange(1, len(signature) + 1)
        level = 2 * np.pi * signature.level
        for values, style in (
            (level, {"color": _LEVEL, "linewidth": 2.5, "label": r"$2\pi\,n$", "drawstyle": "steps-post"}),
            (signature.theta_level, {"color": _V, "linewidth": 0.9, "label": r"$\theta_{level}(t_k)$"}),
            (signature.phi, {"color": COUNTER_CLOCKWISE, "linewidth": 1.2, "label": r"$\varphi(t_k)$"}),
        ):
            shown = thinned(values, _COLUMNS)
            axes.plot(k[shown], values[shown], **style)
        arrivals = signature.unsigned + 1
        if len(arrivals):
            arrivals = arrivals[np.linspace(0, len(arrivals) - 1, min(len(arrivals), _MARKERS)).astype(int)]
            style = {"color": self._text, "markersize": 5, "label": r"$\Delta\varphi=\pm\pi$"}
            axes.plot(k[arrivals], signature.phi[arrivals], "x", **style)
        for turns, style in ((1, ":"), (2, "--")):
            for sign in (1, -1):
                axes.axhline(sign * turns * np.pi, color=self._text, linewidth=0.8, linestyle=style)
        low, high = axes.get_ylim()
        low, high = min(low, -2.3 * np.pi), max(high, 2.3 * np.pi)
        axes.set_ylim(low, high)
        axes.set_xlim(1, max(len(signature), 2))
        step = next(s for s in (1, 2, 4, 10, 20, 40, 100, 1e3, 1e4, 1e5, 1e6) if (high - low) / np.pi <= 9 * s)
        axes.yaxis.set_major_locator(MultipleLocator(step * np.pi))
        axes.yaxis.set_major_formatter(FuncFormatter(_in_pi))
        axes.xaxis.set_major_locator(MaxNLocator(6, integer=True))
        axes.set_xlabel("$k$", color=self._text)
        levels = axes.secondary_yaxis("right", functions=(lambda y: y / (2 * np.pi), lambda n: n * 2 * np.pi))
        levels.yaxis.set_major_locator(MaxNLocator(6, integer=True))
        levels.set_ylabel("$n$", color=self._text, rotation=0)
        levels.tick_params(colors=self._text, labelsize="small")
        legend = axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=4, frameon=False, fontsize="medium",
                             labelcolor=self._text, borderaxespad=0.1)  # fmt: skip
        legend.set_zorder(0)
        self._now = axes.axvline(1, color=self._text, linewidth=1)
        (self._phi_now,) = axes.plot([], [], "o", color=COUNTER_CLOCKWISE, markersize=6)
        (self._theta_now,) = axes.plot([], [], "o", color=_V, markersize=6)
        self._moving += [self._now, self._phi_now, self._theta_now]

    def _move(self) -> None:
        k, signature, vertices = self._k, self.signature, self.vertices
        since = max(0, k + 1 - TRAIL)
        self._trail.set_data(*vertices[since : k + 2].T)
        tip = vertices[k + 1]
        self._v.xy, self._v.xyann = tip, vertices[0]
        self._v_name.xy = tip

        window = slice(since, k + 1)
        grown = _GROWTH * (np.arange(since, k + 1) - since) / min(len(signature), TRAIL)
        for arcs, angle, radius in ((self._arcs[:2], signature.alpha[window], 1.06 + grown),
                                    (self._arcs[2:], signature.theta[window], 0.94 - grown)):  # fmt: skip
            for line, points in zip(arcs, image_arcs(angle, radius)):
                line.set_data(*points.T)
        angle = signature.alpha[window]
        halves = np.flatnonzero(np.isnan(turns_of(angle))) + 1
        self._half_turns.set_data(*_polar(1.06 + grown[halves], angle[halves]))
        alpha, theta = signature.alpha[k], signature.theta[k]
        for at, ray, image, name in ((alpha, self._ray, self._image, self._image_name),
                                     (theta, self._v_ray, self._v_image, self._v_image_name)):  # fmt: skip
            x, y = _polar(1.0, at)
            ray.set_data([0, x], [0, y])
            image.set_data([x], [y])
            inside = name is self._v_image_name
            # Two names side by side where both point the same way.
            name.set_position(_polar(0.8, at + 0.22) if inside else _polar(0.8, at - 0.22))
        self._now.set_xdata([k + 1, k + 1])
        self._phi_now.set_data([k + 1], [signature.phi[k]])
        self._theta_now.set_data([k + 1], [signature.theta_level[k]])

    def _drawn(self) -> None:
        if self.figure.canvas is self:  # saving lends the figure to another canvas
            self._still = self.copy_from_bbox(self.figure.bbox)
            self._draw_moving()

    def _draw_moving(self) -> None:
        for artist in self._moving:
            self.figure.draw_artist(artist)


def _polar(radius, angle) -> tuple:
    return radius * np.cos(angle), radius * np.sin(angle)


def _in_pi(value: float, position=None) -> str:
    multiple = round(value / np.pi)
    if multiple in (-1, 0, 1):
        return {-1: "−π", 0: "0", 1: "π"}[multiple]
    return f"{multiple}π".replace("-", "−")


def _label_lengths(axes, size: float, color: str) -> None:
    """Give the axes FreeCAD's unit for lengths of this size."""
    factor, unit = user().length_unit(max(size, 1e-3))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(5))
        axis.set_major_formatter(
            FuncFormatter(lambda value, position=None: user().number(value / factor).replace("-", "−"))
        )
    axes.set_xlabel(unit, color=color, fontsize="small")
