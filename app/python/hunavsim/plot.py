"""Figures with matplotlib, which must be installed."""

import numpy


def trajectories(run, axes=None, people="0.45", robots="tab:blue", linewidth=1.0):
    """Draws the map, the paths of people and robots and their ends; returns the axes."""
    import matplotlib.pyplot as plt

    axes = axes if axes is not None else plt.subplots()[1]
    draw_map(run, axes)
    rows = run.trajectory
    for body in numpy.unique(rows["id"]):
        track = rows[rows["id"] == body]
        color = robots if body < 0 else people
        axes.plot(track["x"], track["y"], color=color, linewidth=linewidth * (2 if body < 0 else 1))
        axes.plot(track["x"][-1:], track["y"][-1:], "o", color=color, markersize=4)
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    return axes


def draw_map(run, axes):
    """Draws occupied cells of the map."""
    grid = run.map
    if not grid:
        return
    cells, size, (x, y, heading) = grid["cells"], grid["resolution"], grid["origin"]
    if heading != 0.0:
        raise ValueError("a rotated map cannot be drawn as an image")
    extent = (x, x + cells.shape[1] * size, y, y + cells.shape[0] * size)
    shades = numpy.where(cells > 50, 0.35, numpy.where(cells < 0, 0.85, 1.0))
    axes.imshow(shades, cmap="gray", vmin=0.0, vmax=1.0, origin="lower", extent=extent, zorder=0)


def series(run, keys, axes=None):
    """Draws metrics per sample over time; returns the axes."""
    import matplotlib.pyplot as plt

    axes = axes if axes is not None else plt.subplots()[1]
    values = run.series
    for key in [keys] if isinstance(keys, str) else keys:
        axes.plot(values["time"], values[key], label=key)
    axes.set_xlabel("t [s]")
    axes.legend()
    return axes
