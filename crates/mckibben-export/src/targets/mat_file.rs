//! MAT-files of version 5: matrices of doubles and lines of text.
//!
//! The format: MathWorks, "MAT-File Format" (2019), chapter 1: a header of 128 bytes, then one element miMATRIX per variable with the
//! sub-elements flags, dimensions, name and values, each padded to 8 bytes.

pub(super) enum Variable<'a> {
    /// A matrix: rows, then values column by column.
    Matrix(usize, Vec<f64>),
    /// A line of text.
    Text(&'a str),
}

const INT8: u32 = 1;
const UINT16: u32 = 4;
const INT32: u32 = 5;
const UINT32: u32 = 6;
const DOUBLE: u32 = 9;
const MATRIX: u32 = 14;
const CLASS_CHAR: u32 = 4;
const CLASS_DOUBLE: u32 = 6;

fn element(kind: u32, data: &[u8]) -> Vec<u8> {
    let mut out = kind.to_le_bytes().to_vec();
    out.extend((data.len() as u32).to_le_bytes());
    out.extend(data);
    out.resize(out.len().next_multiple_of(8), 0);
    out
}

/// The bytes of a file.
pub(super) fn mat_file(about: &str, variables: &[(&str, Variable<'_>)]) -> Vec<u8> {
    let about: String = about.chars().filter(char::is_ascii).take(100).collect();
    let mut out = format!("MATLAB 5.0 MAT-file, {about}").into_bytes();
    out.truncate(116);
    out.resize(116, b' ');
    out.extend([0; 8]);
    out.extend(0x0100_u16.to_le_bytes());
    out.extend(b"IM");
    for (name, variable) in variables {
        let (class, rows, columns, values) = match variable {
            Variable::Matrix(rows, values) => {
                let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
                (CLASS_DOUBLE, *rows, values.len() / (*rows).max(1), element(DOUBLE, &bytes))
            }
            Variable::Text(text) => {
                let units: Vec<u16> = text.encode_utf16().collect();
                let bytes: Vec<u8> = units.iter().flat_map(|u| u.to_le_bytes()).collect();
                (CLASS_CHAR, 1, units.len(), element(UINT16, &bytes))
            }
        };
        let flags: Vec<u8> = [class, 0].iter().flat_map(|v| v.to_le_bytes()).collect();
        let dimensions: Vec<u8> =
            [rows as i32, columns as i32].iter().flat_map(|v| v.to_le_bytes()).collect();
        let mut data = element(UINT32, &flags);
        data.extend(element(INT32, &dimensions));
        data.extend(element(INT8, name.as_bytes()));
        data.extend(values);
        out.extend(element(MATRIX, &data));
    }
    out
}
