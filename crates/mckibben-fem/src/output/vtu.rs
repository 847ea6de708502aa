//! VTK's XML format for unstructured grids: little-endian, compressed by zlib, in base64 within the
//! file.
//!
//! Source: VTK documentation, "VTK XML Formats". An array is base64(header) base64(zlib(bytes))
//! with the header (number of blocks, size of a block, size of a last shorter block or 0, size of
//! each compressed block).

use crate::element::spatial::Vector;
use base64::{Engine as _, engine::general_purpose::STANDARD};
use flate2::{Compression, write::ZlibEncoder};
use mckibben_core::clean;
use std::io::Write as _;
use thiserror::Error;

/// A line through any number of points.
pub const POLY_LINE: u8 = 4;
/// Eight corners: four counter-clockwise seen from above, then the four above them.
pub const HEXAHEDRON: u8 = 12;

/// Ours run through the wall, around, along; those of other programs around the face.
pub const ORDER: [usize; 8] = [0, 1, 3, 2, 4, 5, 7, 6];

/// A number that is none.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{file} is not written: its {name} contains a value that is not a finite number")]
pub struct VtuError {
    /// The file that would hold it.
    pub file: String,
    /// The data.
    pub name: &'static str,
}

/// Numbers at points.
#[derive(Debug, Clone)]
pub struct PointData {
    /// Name with its unit.
    pub name: &'static str,
    /// Numbers of a point.
    pub components: usize,
    /// All of them.
    pub values: Vec<f64>,
}

impl PointData {
    /// A number at each point.
    pub fn scalar(name: &'static str, values: Vec<f64>) -> Self {
        Self {
            name,
            components: 1,
            values,
        }
    }

    /// Three numbers at each point.
    pub fn vector(name: &'static str, values: Vec<Vector>) -> Self {
        Self {
            name,
            components: 3,
            values: values.concat(),
        }
    }
}

/// A grid of cells of one kind.
#[derive(Debug, Clone)]
pub struct Grid {
    /// VTK's number of the kind.
    pub kind: u8,
    /// Places in mm.
    pub points: Vec<Vector>,
    /// Points of all cells.
    pub connectivity: Vec<i64>,
    /// Where each cell ends in `connectivity`.
    pub offsets: Vec<i64>,
    /// Numbers at points; vectors keep all digits, the rest seven.
    pub data: Vec<PointData>,
    /// Numbers of the whole grid.
    pub field: Vec<(&'static str, f64)>,
}

impl Grid {
    /// Lines of so many points each, one after the other.
    pub fn of_lines(points: Vec<Vector>, per_line: usize, data: Vec<PointData>) -> Self {
        let offsets = (1..=points.len() / per_line)
            .map(|c| (per_line * c) as i64)
            .collect();
        Self {
            kind: POLY_LINE,
            connectivity: (0..points.len() as i64).collect(),
            points,
            offsets,
            data,
            field: vec![],
        }
    }

    /// Hexahedra with eight points each, the first direction running fastest.
    pub fn of_hexahedra(points: Vec<Vector>, cells: &[Vec<u32>], data: Vec<PointData>) -> Self {
        let connectivity: Vec<i64> = cells
            .iter()
            .flat_map(|cell| ORDER.map(|a| i64::from(cell[a])))
            .collect();
        Self {
            kind: HEXAHEDRON,
            points,
            offsets: (1..=connectivity.len() / 8).map(|c| 8 * c as i64).collect(),
            connectivity,
            data,
            field: vec![],
        }
    }

    /// The file; `about` is a comment at its head, `file` is named in errors.
    pub fn to_xml(&self, about: &str, file: &str) -> Result<String, VtuError> {
        let finite = |name: &'static str, ok: bool| {
            if ok {
                Ok(())
            } else {
                Err(VtuError {
                    file: file.into(),
                    name,
                })
            }
        };
        finite(
            "points",
            self.points.iter().flatten().all(|x| x.is_finite()),
        )?;
        for data in &self.data {
            finite(data.name, data.values.iter().all(|x| x.is_finite()))?;
        }
        let mut out = head("UnstructuredGrid", about);
        out.push_str("<UnstructuredGrid>\n<FieldData>\n");
        for (name, value) in &self.field {
            finite(name, value.is_finite())?;
            out += &format!(
                "<DataArray type=\"Float64\" Name=\"{name}\" NumberOfTuples=\"1\" format=\"ascii\">"
            );
            out += &format!("{value:?}</DataArray>\n");
        }
        let points = self.points.len();
        let cells = self.offsets.len();
        out += "</FieldData>\n";
        out += &format!(
            "<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">\n<PointData>\n"
        );
        for PointData {
            name,
            components,
            values,
        } in &self.data
        {
            if *components > 1 {
                array(
                    &mut out,
                    "Float64",
                    name,
                    *components,
                    doubles(values.iter()),
                );
            } else {
                let bytes = values
                    .iter()
                    .flat_map(|x| (*x as f32).to_le_bytes())
                    .collect();
                array(&mut out, "Float32", name, 1, bytes);
            }
        }
        out.push_str("</PointData>\n<Points>\n");
        array(
            &mut out,
            "Float64",
            "Points",
            3,
            doubles(self.points.iter().flatten()),
        );
        out.push_str("</Points>\n<Cells>\n");
        let whole = |x: &[i64]| x.iter().flat_map(|x| x.to_le_bytes()).collect();
        array(
            &mut out,
            "Int64",
            "connectivity",
            1,
            whole(&self.connectivity),
        );
        array(&mut out, "Int64", "offsets", 1, whole(&self.offsets));
        array(&mut out, "UInt8", "types", 1, vec![self.kind; cells]);
        out.push_str("</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
        Ok(out)
    }
}

/// The file that lists step, part, name and file of a series.
pub fn collection(about: &str, files: &[(usize, usize, &str, String)]) -> String {
    let mut out = head("Collection", about);
    out.push_str("<Collection>\n");
    for (step, part, name, file) in files {
        let place = format!("timestep=\"{step}\" group=\"\" part=\"{part}\"");
        out += &format!("<DataSet {place} name=\"{name}\" file=\"{file}\"/>\n");
    }
    out.push_str("</Collection>\n</VTKFile>\n");
    out
}

fn head(kind: &str, about: &str) -> String {
    // In a comment two hyphens must not meet, nor end it.
    let clean = clean::line(about).replace("--", "- -").replace("--", "- -");
    let version = env!("CARGO_PKG_VERSION");
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- mckibben {version}: {clean} \
         -->\n<VTKFile type=\"{kind}\" \
         version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" \
         compressor=\"vtkZLibDataCompressor\">\n"
    )
}

fn doubles<'a>(values: impl Iterator<Item = &'a f64>) -> Vec<u8> {
    values.flat_map(|x| x.to_le_bytes()).collect()
}

fn array(out: &mut String, kind: &str, name: &str, components: usize, bytes: Vec<u8>) {
    let many = if components > 1 {
        format!(" NumberOfComponents=\"{components}\"")
    } else {
        String::new()
    };
    *out += &format!("<DataArray type=\"{kind}\" Name=\"{name}\"{many} format=\"binary\">");
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    // Writing to memory cannot fail.
    let packed = encoder
        .write_all(&bytes)
        .and_then(|()| encoder.finish())
        .unwrap_or_default();
    let header: Vec<u8> = [1, bytes.len() as u64, 0, packed.len() as u64]
        .into_iter()
        .flat_map(u64::to_le_bytes)
        .collect();
    STANDARD.encode_string(header, out);
    STANDARD.encode_string(packed, out);
    out.push_str("</DataArray>\n");
}
