//! The tables that come with the crate.
//!
//! Limits: part of the program; made again by the command that each one names.

use super::table::Table;
use crate::error::AuditError;
use std::sync::OnceLock;

/// All tables.
#[derive(Clone, Debug, PartialEq)]
pub struct Library {
    /// secant stiffness F / (E A e) of a bonded bead over (shape factor, 1 - 2 nu, strain)
    pub bead_load: Table,
    /// held over free expansion of a bonded bead's height over (shape factor, 1 - 2 nu)
    pub held_expansion: Table,
    /// field of a heated bead over that of a cold one of its height and mean area over (shape factor, coverage, film / height, strain)
    pub heated_field: Table,
    /// field over mixture (20)-(21) of the cell of a squeezed, bonded bead over (shape factor, coverage, film / height, strain)
    pub cell_field: Table,
    /// capacitance at the rim over eps0 radius over (bead gap / radius, film / radius, electrode / radius, mean permittivity)
    pub rim_field: Table,
    /// field over plates of the tail over (width / distance, thickness / distance)
    pub tail_edge: Table,
}

/// The tables, read once.
///
/// # Errors
/// [`AuditError::Table`] where a file of the crate is at fault, which the tests rule out.
pub fn library() -> Result<&'static Library, AuditError> {
    static LIBRARY: OnceLock<Result<Library, AuditError>> = OnceLock::new();
    LIBRARY.get_or_init(read).as_ref().map_err(Clone::clone)
}

fn read() -> Result<Library, AuditError> {
    Ok(Library {
        bead_load: table("bead_load", include_str!("../../tables/bead_load.toml"))?,
        held_expansion: table("held_expansion", include_str!("../../tables/held_expansion.toml"))?,
        heated_field: table("heated_field", include_str!("../../tables/heated_field.toml"))?,
        cell_field: table("cell_field", include_str!("../../tables/cell_field.toml"))?,
        rim_field: table("rim_field", include_str!("../../tables/rim_field.toml"))?,
        tail_edge: table("tail_edge", include_str!("../../tables/tail_edge.toml"))?,
    })
}

fn table(name: &'static str, text: &str) -> Result<Table, AuditError> {
    let table: Table = toml::from_str(text).map_err(|e| AuditError::Table { name, problem: e.to_string() })?;
    let wanted: usize = table.axes.iter().map(|a| a.count).product();
    if wanted != table.coefficients.len() {
        let problem = format!("{} coefficients where the axes ask for {wanted}", table.coefficients.len());
        return Err(AuditError::Table { name, problem });
    }
    Ok(table)
}
