"""The scores of a record (experiments/RECORD.md) as the analysis shows and compares them."""

from __future__ import annotations

from dataclasses import dataclass

from analysis.data.errors import InputError


@dataclass(frozen=True)
class Score:
    """How one score is shown, which direction is better, and which difference would matter."""

    name: str
    label: str
    unit: str  # empty: a number or a count
    better: str  # "lower" or "higher"
    decimals: int
    smallest_difference: float
    """Smallest interesting difference between two methods, in `unit`; per frame if `summed`."""
    summed: bool = False
    """The score is a sum over the frames of a trial."""

    @property
    def axis_label(self) -> str:
        """Label with unit, as an axis or a table head shows it."""
        return f"{self.label} ({self.unit})" if self.unit else self.label

    @property
    def difference_decimals(self) -> int:
        """Differences are small against the values: one digit more, but no tenths of a voxel."""
        return self.decimals + 1 if self.decimals else 0

    def interesting(self, frames: int) -> float:
        """Smallest interesting difference of a trial of so many frames, in `unit`."""
        return self.smallest_difference * (frames if self.summed else 1)


# Smallest interesting differences are assumed: half of the least difference that the paper itself
# reports (Table 1: 0.02 percentage points and about 3.5 voxels a frame; Sec. 4.1.3: 0.01 m/s static
# and 0.03 m/s dynamic), and values of the same order for the scores it does not have.
_SCORES = (
    Score("accuracy_pct", "accuracy", "%", "higher", 2, 0.01),
    Score("case1_voxels", "case 1 false voxels", "", "lower", 0, 1.75, summed=True),
    Score("case2_voxels", "case 2 false voxels", "", "lower", 0, 1.75, summed=True),
    Score("mixed_voxels_per_frame", "mixed false voxels", "per frame", "lower", 1, 1.75),
    Score("accuracy_visible_pct", "accuracy, visible truth", "%", "higher", 2, 0.01),
    Score("case1_visible_voxels", "case 1, visible truth", "", "lower", 0, 1.75, summed=True),
    Score("case2_grown_voxels", "case 2, grown truth", "", "lower", 0, 1.75, summed=True),
    Score("precision", "precision", "", "higher", 3, 0.01),
    Score("precision_near", "precision, grown truth", "", "higher", 3, 0.01),
    Score("recall", "recall", "", "higher", 3, 0.01),
    Score("f1", "F1", "", "higher", 3, 0.01),
    Score("iou_visible", "IoU, visible truth", "", "higher", 3, 0.01),
    Score("brier", "Brier score", "", "lower", 4, 0.001),
    Score("ghost_voxels_per_frame", "ghost voxels", "per frame", "lower", 1, 1.0),
    Score("seconds_to_clear", "time until 90% is cleared", "s", "lower", 2, 0.1),
    Score("mover_voxels_found_pct", "hit voxels of movers found", "%", "higher", 1, 1),
    Score("static_velocity_error_mps", "static velocity error", "m/s", "lower", 3, 0.005),
    Score("static_velocity_error_p95_mps", "static velocity error, p95", "m/s", "lower", 3, 0.01),
    Score("dynamic_velocity_error_mps", "dynamic velocity error", "m/s", "lower", 3, 0.015),
    Score("static_velocity_error_steady_mps", "static error, steady", "m/s", "lower", 3, 0.005),
    Score("dynamic_velocity_error_steady_mps", "dynamic error, steady", "m/s", "lower", 3, 0.015),
    Score("recovery_s", "recovery after a turn", "s", "lower", 2, 0.05),
    Score("recovery_p90_s", "recovery after a turn, p90", "s", "lower", 2, 0.1),
    Score("velocity_in_ellipse_pct", "truth in the 95% ellipse", "%", "higher", 1, 1),
    Score("time_to_converge_s", "time to converge", "s", "lower", 2, 0.1),
    Score("objects_missed_pct", "objects missed", "%", "lower", 2, 0.5),
    Score(
        "clusters_without_object_per_frame", "clusters without object", "per frame", "lower", 2, 0.1
    ),
    Score("movers_called_dynamic_pct", "movers called dynamic", "%", "higher", 1, 1),
    Score("false_movers_per_frame", "false movers", "per frame", "lower", 2, 0.05),
    Score("tracks_per_stay", "tracks", "per stay", "lower", 2, 0.1),
    Score("track_switches_per_stay", "track switches", "per stay", "lower", 2, 0.1),
    Score("track_switches_per_minute", "track switches", "per minute and object", "lower", 2, 0.1),
    Score("occlusions_kept_pct", "occlusions with track kept", "%", "higher", 1, 5),
    Score("hidden_with_cluster_pct", "hidden frames with cluster", "%", "higher", 1, 5),
)

SCORES = {score.name: score for score in _SCORES}

MAIN_SCORES = (
    "accuracy_pct",
    "mixed_voxels_per_frame",
    "static_velocity_error_mps",
    "dynamic_velocity_error_mps",
)
"""What a sweep shows unless told otherwise."""


def find_scores(names: list[str]) -> list[Score]:
    """The scores of these names, in this order.

    Raises
    ------
    InputError
        Naming the first unknown one.
    """
    for name in names:
        if name not in SCORES:
            raise InputError(f"--scores: {name!r} is not one of {', '.join(SCORES)}")
    return [SCORES[name] for name in names]
