//! Effects of one's own from files: `truegap diagnose ... --effect FILE`.
//!
//! Limits: one mechanism a file; its format is that of [`truegap_diagnose::mechanism::MechanismFile`].

use std::path::{Path, PathBuf};
use truegap_diagnose::Library;
use truegap_diagnose::mechanism::{Composed, MechanismError, MechanismFile};

/// Why a file is no effect.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum EffectFileError {
    /// The file cannot be read.
    #[error("{file}: cannot be read: {source}; give a mechanism's TOML, as `discovered.toml` of a diagnosis")]
    Read { file: PathBuf, source: std::io::Error },
    /// Not TOML, or not these words.
    #[error("{file}: {message}; docs/mechanisms.md lists the words")]
    Parse { file: PathBuf, message: String },
    /// Words without their numbers, or numbers that cannot be.
    #[error("{file}: {source}")]
    Mechanism { file: PathBuf, source: MechanismError },
    /// A name that is taken.
    #[error("{file}: the library has an effect `{id}` already; give yours another id")]
    Taken { file: PathBuf, id: String },
}

/// The effect that a file describes.
///
/// # Errors
/// [`EffectFileError`] where it is not there or describes none.
pub fn effect(file: &Path) -> Result<Composed, EffectFileError> {
    let text = truegap_limits::read_text(file).map_err(|source| EffectFileError::Read { file: file.to_owned(), source })?;
    let parsed: MechanismFile = toml::from_str(&text)
        .map_err(|e| EffectFileError::Parse { file: file.to_owned(), message: e.to_string().trim().to_owned() })?;
    parsed.effect().map_err(|source| EffectFileError::Mechanism { file: file.to_owned(), source })
}

/// The library with the effects of these files.
///
/// # Errors
/// As [`effect`]; [`EffectFileError::Taken`] where an id is in the library.
pub fn with_effects(library: Library, files: &[PathBuf]) -> Result<Library, EffectFileError> {
    files.iter().try_fold(library, |library, file| {
        let effect = effect(file)?;
        if library.find(effect.id.0).is_some() {
            return Err(EffectFileError::Taken { file: file.clone(), id: effect.id.0.to_owned() });
        }
        Ok(library.with(Box::new(effect)))
    })
}
