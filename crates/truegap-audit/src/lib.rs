//! Every assumption of the analytic model measured by finite elements.
