"""What the cases' plots share: cases/NAME/plot FOLDER... -o PICTURE.png, where each folder is that of a run."""

import sys
from pathlib import Path

import matplotlib
matplotlib.use("Agg")  # no display
import matplotlib.pyplot as plt  # noqa: E402

import caselib  # noqa: E402


def arguments(usage):
    """The runs and the picture that the command line names."""
    words = sys.argv[1:]
    if "-o" not in words[:-1] or len(words) < 3:
        sys.exit(usage)
    place = words.index("-o")
    picture = Path(words[place + 1])
    return [caselib.Run(folder) for folder in words[:place] + words[place + 2:]], picture


def panels(number, width=5.2, height=4.2, rows=1):
    columns = -(-number // rows)
    figure, grid = plt.subplots(rows, columns, figsize=(width * columns, height * rows), squeeze=False)
    return figure, grid.flatten()


def save(figure, picture, grid=True):
    for axes in figure.axes:
        if grid:
            axes.grid(alpha=0.3)
        if axes.get_legend_handles_labels()[1]:
            axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(picture, dpi=130)
    print(f"wrote {picture}")
