//! A workbook (Office Open XML, ECMA-376) with the form as formulas: who changes a pressure or a length there sees the pull that follows.

use super::entry::TargetEntry;
use super::zip::zip;
use crate::error::ExportError;
use crate::form::{FUNCTIONS, PRESSURE_KNOTS};
use crate::muscle::ExportedMuscle;
use crate::template::number;
use crate::{Artefact, File};
use std::fmt::Write as _;

pub(super) const ENTRY: TargetEntry = TargetEntry {
    name: "xlsx",
    about: "a workbook with the form as live formulas",
    needs: "LibreOffice Calc, or another program that reads xlsx",
    loses: "friction, both inverses, and the volume of a slack muscle",
    make,
};

enum Cell {
    Number(f64),
    Text(String),
    Formula(String),
}
use Cell::{Formula, Number, Text};

fn make(muscle: &ExportedMuscle) -> Result<Artefact, ExportError> {
    let files = [
        ("[Content_Types].xml", include_str!("../../templates/xlsx/types.xml").to_owned()),
        ("xl/worksheets/sheet1.xml", sheet(&points(muscle))),
        ("_rels/.rels", include_str!("../../templates/xlsx/rels.xml").to_owned()),
        ("xl/workbook.xml", include_str!("../../templates/xlsx/workbook.xml").to_owned()),
        ("xl/_rels/workbook.xml.rels", include_str!("../../templates/xlsx/workbook_rels.xml").to_owned()),
        ("xl/worksheets/sheet2.xml", sheet(&coefficients(muscle))),
    ];
    let all: Vec<(&str, &[u8])> = files.iter().map(|(name, text)| (*name, text.as_bytes())).collect();
    Ok(Artefact { files: vec![File::bytes("muscle.xlsx", "the workbook", zip(&all)?)], notes: vec![] })
}

/// A, B, …, Z, AA, …
fn column(index: usize) -> String {
    let letter = |k: usize| char::from(b'A' + (k % 26) as u8);
    if index < 26 { letter(index).into() } else { format!("{}{}", letter(index / 26 - 1), letter(index)) }
}

fn sheet(rows: &[Vec<Cell>]) -> String {
    let escaped = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let mut out = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<worksheet xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\"><sheetData>\n",
    );
    for (r, row) in rows.iter().enumerate() {
        let _ = write!(out, "<row r=\"{}\">", r + 1);
        for (c, cell) in row.iter().enumerate() {
            let place = format!("{}{}", column(c), r + 1);
            let _ = match cell {
                Number(value) => write!(out, "<c r=\"{place}\"><v>{}</v></c>", number(*value)),
                Text(text) => {
                    let text = escaped(text);
                    write!(out, "<c r=\"{place}\" t=\"inlineStr\"><is><t>{text}</t></is></c>")
                }
                Formula(text) => write!(out, "<c r=\"{place}\"><f>{}</f></c>", escaped(text)),
            };
        }
        out += "</row>\n";
    }
    out + "</sheetData></worksheet>\n"
}

/// Rows of the second sheet before those of the nodes.
const BEFORE: usize = 6;

/// Nodes, values and slopes, and the integrals of the functions from the lower end of the box.
fn coefficients(muscle: &ExportedMuscle) -> Vec<Vec<Cell>> {
    let form = &muscle.form;
    let text = |text: &str| Text(text.into());
    let mut rows = vec![
        vec![text("length at rest, m"), Number(form.length_m)],
        vec![text("supply, Pa"), Number(form.supply_pa)],
        std::iter::once(text("v, m3")).chain(form.v.map(Number)).collect(),
        vec![],
        vec![],
        vec![text("contraction")],
    ];
    for what in ["value, N", "slope, N", "integral, N"] {
        rows[BEFORE - 1].extend((0..FUNCTIONS).map(|i| Text(format!("c{i}: {what}"))));
    }
    for (n, node) in form.contractions.iter().enumerate() {
        let mut row = vec![Number(*node)];
        row.extend(form.a.iter().chain(&form.b).map(|of| Number(of[n])));
        let (r, before) = (BEFORE + n + 1, BEFORE + n);
        row.extend((0..FUNCTIONS).map(|i| {
            let (a, b, sum) = (column(1 + i), column(1 + FUNCTIONS + i), column(1 + 2 * FUNCTIONS + i));
            if n == 0 {
                return Number(0.0);
            }
            Formula(format!(
                "{sum}{before}+0.5*(A{r}-A{before})*({a}{before}+{a}{r}+(A{r}-A{before})/6*({b}{before}-{b}{r}))"
            ))
        }));
        rows.push(row);
    }
    rows
}

/// Facts, and points with a pressure and a length each; to the right of the answers the steps to them.
fn points(muscle: &ExportedMuscle) -> Vec<Vec<Cell>> {
    let form = &muscle.form;
    let mut rows: Vec<Vec<Cell>> = muscle.facts().into_iter().map(|fact| vec![Text(fact)]).collect();
    rows.push(vec![Text("Change pressures and lengths, or copy the last row further down.".into())]);
    let heads = "pressure, Pa|length, m|pull, N|stiffness, N/m|pull by pressure, m2|volume, m3|status|q|contraction|in the box|part|its length|place|beyond|c0'|c1'|c2'|c3'|c4'|c0|c1|c2|c3|c4|phi0|phi1|phi2|phi0'|phi1'|phi2'|C1|C2|C3|C4|pull or push, N";
    rows.push(heads.split('|').map(|head| Text(head.into())).collect());
    let last = BEFORE + form.contractions.len();
    let range = |c: usize| format!("Coefficients!${0}${1}:${0}${last}", column(c), BEFORE + 1);
    let nodes = range(0);
    let of = |c: usize, next: usize, r: usize| format!("INDEX({},K{r}+{next})", range(c));
    let (length, supply) = ("Coefficients!$B$1", "Coefficients!$B$2");
    for k in 0..40 {
        let r = rows.len() + 1;
        let (q, share) = (0.125 * f64::from(1 + k / 5), f64::from(k % 5) / 4.0);
        let e = form.contraction_low + share * (form.contraction_high - form.contraction_low);
        let mut row = vec![Number(form.supply_pa * q), Number(form.length_m * (1.0 - e))];
        let (low, high) = (format!("Coefficients!$A${}", BEFORE + 1), format!("Coefficients!$A${last}"));
        let mut formulas = vec![
            format!("MAX(0,AI{r})"),
            format!("IF(AI{r}<=0,0,-(O{r}+P{r}*H{r}+Q{r}*Y{r}+R{r}*Z{r}+S{r}*AA{r})/{length})"),
            format!("IF(AI{r}<=0,0,(U{r}+V{r}*AB{r}+W{r}*AC{r}+X{r}*AD{r})/{supply})"),
            format!(
                "IF(AI{r}<=0,\"\",Coefficients!$B$3+Coefficients!$C$3*H{r}+Coefficients!$D$3*Y{r}+Coefficients!$E$3*Z{r}+Coefficients!$F$3*AA{r}+{length}/{supply}*(AE{r}+AF{r}*AB{r}+AG{r}*AC{r}+AH{r}*AD{r}))"
            ),
            format!(
                "IF(AI{r}<=0,1,0)+IF(AND(A{r}>=0,A{r}<={supply}),0,2)+IF(AND(I{r}>={low},I{r}<={high}),0,4)"
            ),
            format!("A{r}/{supply}"),
            format!("1-B{r}/{length}"),
            format!("MEDIAN(I{r},{low},{high})"),
            format!("MIN(MATCH(J{r},{nodes},1),{})", form.contractions.len() - 1),
            format!("{}-{}", of(0, 1, r), of(0, 0, r)),
            format!("(J{r}-{})/L{r}", of(0, 0, r)),
            format!("I{r}-J{r}"),
        ];
        // Values and slopes at both ends of the part.
        let ends = |i: usize| {
            let b = 1 + FUNCTIONS + i;
            [of(1 + i, 0, r), of(b, 0, r), of(1 + i, 1, r), of(b, 1, r)]
        };
        for i in 0..FUNCTIONS {
            let [a, b, c, d] = ends(i);
            formulas
                .push(format!("6*M{r}*(1-M{r})/L{r}*({c}-{a})+(1-M{r})*(1-3*M{r})*{b}+M{r}*(3*M{r}-2)*{d}"));
        }
        for i in 0..FUNCTIONS {
            let ([a, b, c, d], slope) = (ends(i), column(14 + i));
            formulas.push(format!(
                "(1+2*M{r})*(1-M{r})^2*{a}+L{r}*M{r}*(1-M{r})^2*{b}+M{r}^2*(3-2*M{r})*{c}-L{r}*M{r}^2*(1-M{r})*{d}+{slope}{r}*N{r}"
            ));
        }
        let place = |knot: f64| format!("MEDIAN(0,H{r}-{knot},{})", 1.0 - knot);
        formulas.extend(PRESSURE_KNOTS.map(|knot| format!("{0}*({0}+2*MAX(H{r}-1,0))", place(knot))));
        formulas.extend(PRESSURE_KNOTS.map(|knot| format!("2*{}", place(knot))));
        for i in 1..FUNCTIONS {
            let ([a, b, c, d], sum) = (ends(i), of(1 + 2 * FUNCTIONS + i, 0, r));
            let (value, slope) = (column(19 + i), column(14 + i));
            formulas.push(format!(
                "{sum}+L{r}*((M{r}-M{r}^3+M{r}^4/2)*{a}+(M{r}^3-M{r}^4/2)*{c}+L{r}*((M{r}^2/2-2/3*M{r}^3+M{r}^4/4)*{b}+(M{r}^4/4-M{r}^3/3)*{d}))+N{r}*({value}{r}-{slope}{r}*N{r}/2)"
            ));
        }
        formulas.push(format!("T{r}+U{r}*H{r}+V{r}*Y{r}+W{r}*Z{r}+X{r}*AA{r}"));
        row.extend(formulas.into_iter().map(Formula));
        rows.push(row);
    }
    rows
}
