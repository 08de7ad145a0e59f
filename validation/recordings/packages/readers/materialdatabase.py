"""Reads files of the package materialdatabase."""

import json


def ferrite(content, material, least):
    """Angle by which the flux of a core is behind its field, over the flux: a run each warmth and frequency, rows with at least so many T."""
    measured = json.loads(content)[material]["measurements"]["complex_permeability"]["LEA_LK"]["measurement_data"]
    rows = [(k, one["frequency"] / 1000, flux, angle) for k, one in enumerate(measured, 1) for flux, angle in zip(one["flux_density"], one["mu_phi_deg"]) if flux >= least]
    return dict(zip(("run", "frequency_khz", "flux_t", "angle_deg"), zip(*rows)))
