# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results as plain data, which can be printed as a table and saved as CSV or JSON.

Input: the `Recognition`, costs, cautions and remarks (Messages) of each operation, and the facts of a simulation.
Output: `Report`, with an `OperationReport` for each operation and a `Total` for each job; `SimulationFacts` and
`JobVerdict`; `SimulatedPart`, with the pictures and the solid of a simulated part.
"""

from vkworkbench.report.job_verdict import JobVerdict, fingerprint_of_job
from vkworkbench.report.operation import (
    HANGS,
    SERIOUS,
    OperationReport,
    Setup,
    cells_of,
    contradiction,
    is_switched_off,
    setup_of,
    without_results,
)
from vkworkbench.report.report import Cancelled, Report
from vkworkbench.report.simulated_part import SimulatedPart
from vkworkbench.report.simulation_facts import SimulationFacts
from vkworkbench.report.spreadsheet import as_cell
from vkworkbench.report.text_table import files_left_out, how_many, printable
from vkworkbench.report.total import Total, compare_setups, compare_with_sum, has_unknown_cost, total_of
from vkworkbench.report.travel import extent_of, with_travel

__all__ = [
    "HANGS", "SERIOUS", "Cancelled", "JobVerdict", "OperationReport", "Report", "Setup", "SimulatedPart", "SimulationFacts", "Total", "as_cell", "cells_of",
    "compare_setups", "compare_with_sum", "contradiction", "extent_of", "files_left_out", "fingerprint_of_job", "has_unknown_cost", "how_many", "is_switched_off", "printable", "setup_of", "total_of", "with_travel", "without_results",
]  # fmt: skip
