use crate::figures;
use mckibben_report::*;
#[test]
fn snap() {
    let dir = std::path::PathBuf::from(std::env::var("SNAP").unwrap());
    std::fs::create_dir_all(&dir).unwrap();
    for (name, f) in figures::all() {
        std::fs::write(dir.join(format!("{name}.svg")), f.to_svg().unwrap()).unwrap();
        std::fs::write(dir.join(format!("{name}.html")), f.to_html().unwrap()).unwrap();
        std::fs::write(dir.join(format!("{name}.pdf")), f.to_pdf().unwrap()).unwrap();
        std::fs::write(dir.join(format!("{name}.png")), f.to_png().unwrap()).unwrap();
        for mm in [85.0, 180.0] {
            if let Ok(t) = f.clone().width_mm(mm).to_svg() {
                std::fs::write(dir.join(format!("{name}{mm}.svg")), t).unwrap();
            }
        }
    }
    let mut s = Sheet::new("a".into(), 100.0, 80.0);
    s.line(Pen::Axis, vec![[1.0, 2.0], [30.0, 40.0]]);
    s.outline(Pen::Outline, vec![[1.0, 2.0], [30.0, 40.0], [10.0, 3.0]]);
    s.fill(vec![[1.0, 2.0], [30.0, 40.0], [10.0, 3.0]]);
    s.circle(Pen::Thin, [20.0, 20.0], 5.0);
    s.text([3.0, 4.0], 3.0, Anchor::Middle, "ab<c");
    s.text_upwards([3.0, 4.0], 3.0, Anchor::End, "ab<c");
    std::fs::write(dir.join("sheet.svg"), s.to_svg().unwrap()).unwrap();
    std::fs::write(dir.join("sheet.pdf"), s.to_pdf().unwrap()).unwrap();
    let t = |t: &str| t.to_owned();
    let d = Document {
        title: t("T<"),
        title_block: vec![(t("a"), t("b"))],
        lead: t("l"),
        footer: t("f"),
        parts: vec![
            Part::Heading(t("h")),
            Part::Text(t("x&y")),
            Part::List(vec![t("1"), t("2")]),
            Part::Table {
                head: vec![t("a"), t("b")],
                rows: vec![vec![
                    t("1"),
                    t("a long long long long long text of more than forty letters"),
                ]],
            },
            Part::Table {
                head: vec![],
                rows: vec![vec![t("1"), t("2")]],
            },
            Part::Figure(Box::new(figures::models())),
            Part::Drawing(t("<svg/>")),
            Part::Code(t("a\n b")),
            Part::Body(t("{}")),
        ],
    };
    std::fs::write(
        dir.join("doc.html"),
        d.to_html("let a = '</script>'").unwrap(),
    )
    .unwrap();
}
