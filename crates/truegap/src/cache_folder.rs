//! Where what may be computed again is kept between runs.
//!
//! Limits: `$TRUEGAP_CACHE`, else `$XDG_CACHE_HOME/truegap`, else `~/.cache/truegap`; none where the system names none of them.

use std::path::PathBuf;

/// The folder for one kind of thing.
pub fn cache_folder(kind: &str) -> Option<PathBuf> {
    let variable = |name: &str| std::env::var_os(name).filter(|v| !v.is_empty()).map(PathBuf::from);
    let cache = variable("TRUEGAP_CACHE").or_else(|| variable("XDG_CACHE_HOME").map(|c| c.join("truegap")));
    cache.or_else(|| variable("HOME").map(|h| h.join(".cache/truegap"))).map(|c| c.join(kind))
}
