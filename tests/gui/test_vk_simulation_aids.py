# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measuring, sections, the path of the tool and the axes in the simulation tab."""

from __future__ import annotations

import re

import numpy as np
import pytest
from PySide import QtCore
from simulation_window import finest

from vkworkbench.core.rendering import CUT_OPEN
from vkworkbench.gui.simulation.pictures import PATH_DONE, PATH_TO_COME


@pytest.fixture
def player(desk, window):
    """A player of the whole example, seen from above."""
    return desk.shared(desk.example, "Top").player


def place(player, share):
    """Return a point of the part's view; across and down are shares of the view's width and height."""
    return QtCore.QPoint(*(int(part * side) for part, side in zip(share, (player.view.width(), player.view.height()))))


def numbers(text):
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?(?= mm)", text)]


def lowest_place(player):
    """Return the point of the view with the lowest surface whose surroundings are level."""
    scene = player.view._scene
    depth = np.where(np.isnan(scene.depth), -np.inf, scene.depth)
    level = np.abs(depth[2:-2, 2:-2] - np.roll(depth, 2, 0)[2:-2, 2:-2]) < 1e-3
    level &= np.abs(depth[2:-2, 2:-2] - np.roll(depth, 2, 1)[2:-2, 2:-2]) < 1e-3
    row, column = np.unravel_index(np.argmax(np.where(level, depth[2:-2, 2:-2], -np.inf)), level.shape)
    ratio = player.view.devicePixelRatioF()
    ratio *= scene.depth.shape[0] / scene.pixels.shape[0]  # the depths of an averaged picture are finer
    return QtCore.QPoint(int((column + 2) / ratio), int((scene.depth.shape[0] - 3 - row) / ratio))


def test_click_shows_the_depth_of_a_pocket(player, window):
    where = lowest_place(player)
    surface = player.view.surface_at(where)
    window.click_at(player.view, where)
    window.wait(lambda: player.pictures.is_current and "Depth below" in player.play_bar.text.text())
    top = player.job.stock.upper[2]
    assert numbers(player.play_bar.text.text())[0] == pytest.approx(top - surface.place[2], abs=0.01)
    assert surface.place[2] < top - 1
    window.screenshot("simulation-depth")


def test_clicked_depth_is_exact_in_an_oblique_view(player, window):
    """The operation *Face* cuts 1.5 mm below the top of the stock."""
    player.look("Isometric")
    finest(player, window)
    spots = [place(player, (x / 20, y / 20)) for x in range(20) for y in range(20)]
    found = [player.view.surface_at(spot) for spot in spots]
    faced = {s.place[2] for s in found if s and s.owner >= 0 and player.clock.cuts.source(s.owner).cut == 0}
    player.look("Top")
    top = player.job.stock.upper[2]
    assert any(top - z == pytest.approx(1.5, abs=1e-3) for z in faced)


def test_two_clicks_show_the_distance_between_them(player, window):
    bar, view = player.scene_bar, player.view
    moment = player.moment.seconds
    bar.measure.trigger()
    one, other = place(player, (0.4, 0.5)), place(player, (0.6, 0.4))
    points = [view.surface_at(where).place for where in (one, other)]
    window.click_at(view, one)
    assert "second point" in player.play_bar.text.text()
    window.click_at(view, other)
    apart = points[1] - points[0]
    assert numbers(player.play_bar.text.text()) == pytest.approx([np.linalg.norm(apart), *apart], abs=0.01)
    pixel = view.view.pixel * view.devicePixelRatioF()
    assert apart[0] == pytest.approx((other - one).x() * pixel, abs=2 * pixel)
    assert player.moment.seconds == moment  # measuring does not change the shown moment
    window.screenshot("simulation-measured")
    window.press(player.time_line, QtCore.Qt.Key_Escape)
    window.wait(lambda: player.pictures.is_current)
    assert not bar.measure.isChecked() and view._measured == () and player.isVisible()
    assert "Distance" not in player.play_bar.text.text()


def test_cut_face_is_filled_and_follows_the_slider(player, window):
    bar = player.scene_bar
    player.look("Isometric")
    bar.section.begin(1)
    finest(player, window)
    assert bar.section.isVisible() and bar.section.place.text().startswith("Y ")
    face = player.view._scene.owner == CUT_OPEN
    assert face.sum() > 500
    window.screenshot("simulation-section")
    bar.section.slider.setValue(800)
    finest(player, window)
    assert (face != (player.view._scene.owner == CUT_OPEN)).any()
    bar.section.begin(None)
    finest(player, window)
    assert not bar.section.isVisible() and (player.view._scene.owner != CUT_OPEN).all()


def test_past_and_future_path_have_different_colours(player, window):
    def count(color):
        return int((player.view._scene.image == color).all(axis=-1).sum())

    player.moment.go_to(0.5 * player.clock.total)
    finest(player, window)
    assert not count(PATH_DONE) and not count(PATH_TO_COME)
    player.scene_bar.path.trigger()
    finest(player, window)
    assert count(PATH_DONE) > 50 and count(PATH_TO_COME) > 50
    window.screenshot("simulation-path")


def test_zoomed_in_part_is_simulated_finer(player, window):
    view, whole = player.view, player.simulation
    coarse = whole.zbuffer.frame.pixel
    player.look("Isometric")
    finest(player, window)
    window.wheel(view, view.rect().center(), 16)
    assert view.frame.pixel < coarse / 3
    window.wait(lambda: player.drawing.detail is not None, 60)
    detail = player.drawing.detail
    finest(player, window)
    assert player.simulation is whole and player.drawing.finest_for(view.frame) is detail
    assert detail.zbuffer.frame.pixel < 0.7 * coarse
    frame, stock = detail.zbuffer.frame, player.job.stock
    # Only the visible part of the stock is simulated.
    assert frame.width * frame.pixel < 0.6 * (stock.upper - stock.lower)[0]
    window.screenshot("simulation-zoomed")
    player.look("Isometric")
    assert player.drawing.finest_for(view.frame) is whole
    finest(player, window)
