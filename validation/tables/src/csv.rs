//! Result files with a header and rows, shown as they stand.
//!
//! Limits: commas, one line a row; a cell with a comma stands in double quotes, a quote in it is doubled.

use crate::{error::TablesError, markdown::Markdown};
use std::path::Path;

/// A file as a table.
///
/// # Errors
/// [`TablesError`] where the file cannot be read or a row has another number of cells than the header.
pub(crate) fn read(path: &Path) -> Result<Markdown, TablesError> {
    let text = std::fs::read_to_string(path).map_err(TablesError::at(path))?;
    let mut lines = text.lines().enumerate().filter(|(_, line)| !line.is_empty()).map(|(index, line)| (index + 1, cells(line)));
    let header = lines.next().map(|(_, header)| header).unwrap_or_default();
    let columns = header.len();
    let row = |(line, row): (usize, Vec<String>)| match row.len() == columns {
        true => Ok(row),
        false => Err(TablesError::Cells { path: path.to_owned(), line, cells: row.len(), columns }),
    };
    let rows = lines.map(row).collect::<Result<_, _>>()?;
    Ok(Markdown { header, rows })
}

/// The cells of a line.
fn cells(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let (mut quoted, mut characters) = (false, line.chars().peekable());
    while let Some(character) = characters.next() {
        match character {
            '"' if quoted && characters.peek() == Some(&'"') => {
                characters.next();
                cells.last_mut().into_iter().for_each(|cell| cell.push('"'));
            }
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            other => cells.last_mut().into_iter().for_each(|cell| cell.push(other)),
        }
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quoted_cells_hold_commas_and_quotes() {
        assert_eq!(cells(r#"a,"b, c","say ""d""","#), ["a", "b, c", r#"say "d""#, ""]);
    }
}
