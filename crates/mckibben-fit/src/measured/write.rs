//! Points → a table with the headings of this program.

use super::{DataPoint, Quantity};
use mckibben_core::{joined, muscle::Measure};

/// The cells of a point with their headings; `None` where a cell is blank.
fn cells(p: &DataPoint) -> Vec<(&'static str, Option<String>)> {
    let number = |value: Option<f64>| value.map(|v| v.to_string());
    let error = |of: Quantity| number(p.error.filter(|_| p.measured == of));
    let other = |w: &&(&str, Quantity)| w.1 == p.measured && w.1 != Quantity::Force;
    let measured = Quantity::WORDS.iter().find(other);
    let mut cells = vec![
        ("pressure_mpa", number(Some(p.at.pressure_mpa))),
        ("contraction", number(Some(p.at.contraction))),
        ("force_n", number(Some(p.at.force_n))),
        ("branch", p.at.branch.map(|b| b.to_string())),
        ("measured", measured.map(|w| w.0.to_owned())),
        ("volume_mm3", number(p.volume_mm3)),
        ("force_error_n", error(Quantity::Force)),
        ("contraction_error", error(Quantity::Contraction)),
        ("pressure_error_mpa", error(Quantity::Pressure)),
        ("volume_error_mm3", error(Quantity::Volume)),
        ("weight", number(Some(p.weight).filter(|w| *w != 1.0))),
    ];
    let measure = |(m, value): (&Measure, Option<f64>)| Some((m.field?, number(value)));
    cells.extend(p.section.values().into_iter().filter_map(measure));
    cells
}

/// A table that [`read_data`](super::read_data) reads as these points, with the columns that they
/// need.
pub fn table(points: &[DataPoint]) -> String {
    let rows: Vec<_> = points.iter().map(cells).collect();
    let is_needed = |column: usize| rows.iter().any(|row| row[column].1.is_some());
    let line = |row: &[(&str, Option<String>)], text: fn(&(&str, Option<String>)) -> String| {
        let cells = row
            .iter()
            .enumerate()
            .filter(|(column, _)| is_needed(*column));
        joined(cells.map(|(_, cell)| text(cell)), ",") + "\n"
    };
    let headings = rows.first().map(|row| line(row, |cell| cell.0.into()));
    let lines = rows
        .iter()
        .map(|row| line(row, |cell| cell.1.clone().unwrap_or_default()));
    headings.into_iter().chain(lines).collect()
}

#[cfg(test)]
mod tests {
    use super::{super::read_data, *};

    /// An identity: points with every column come back as they were, but for their lines.
    #[test]
    fn points_that_are_written_and_read_are_the_same() {
        let text = "pressure_mpa,contraction,force_n,branch,measured,volume_mm3,force_error_n,\
            contraction_error,pressure_error_mpa,volume_error_mm3,weight,outer_diameter_mm,wall_mm,\
            length_mm,angle_deg\n\
            0.1,0.05,120.25,contraction,force,,2,,,,1,20,1.5,200,25\n\
            0.2,0.15,0,elongation,contraction,,,0.005,,,2,20,1.5,250,25\n\
            0.30000000000000004,0.1,80,mean,pressure,,,,0.01,,0.5,20,1.5,300,24.5\n\
            0.2,0.1,0,,volume,91234.5,,,,100,1,20,1.5,300,25\n";
        let points = read_data(text).unwrap();
        let written = table(&points);
        assert_eq!(read_data(&written).unwrap(), points, "{written}");
        assert_eq!(points.len(), 4);
        // Columns that nothing is in are left out.
        let plain =
            table(&read_data("pressure_bar,contraction_percent,force_n\n2,10,80\n").unwrap());
        assert_eq!(plain, "pressure_mpa,contraction,force_n\n0.2,0.1,80\n");
    }
}
