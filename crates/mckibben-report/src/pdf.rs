//! The figure as PDF (ISO 32000-1): the same SVG as one page of vectors of the figure's size, its texts as outlines.

use std::fmt::Write as _;
use std::io::Write as _;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use resvg::tiny_skia::{PathSegment, Point};
use resvg::usvg::{self, Fill, FillRule, Group, LineCap, LineJoin, Node, Paint, Stroke, Transform};

use crate::png::raster;
use crate::{Figure, FigureError, texts_as_outlines};

/// Points (1/72 in) for each pixel of CSS (1/96 in).
const POINTS: f32 = 0.75;

impl Figure {
    /// The figure as a PDF page of its size.
    pub fn to_pdf(&self) -> Result<Vec<u8>, FigureError> {
        render(&self.to_svg()?, &self.title)
    }
}

/// A drawing as a PDF page of its size.
pub(crate) fn render(svg: &str, title: &str) -> Result<Vec<u8>, FigureError> {
    let tree = usvg::Tree::from_str(&texts_as_outlines(svg)?, &usvg::Options::default()).map_err(raster)?;
    let (width, height) = (tree.size().width() * POINTS, tree.size().height() * POINTS);
    // From pixels below the upper edge to points above the lower one.
    let mut page =
        Page { content: format!("{POINTS} 0 0 -{POINTS} 0 {} cm\n", number(height)), opacities: vec![] };
    page.group(tree.root())?;
    let mut stream = ZlibEncoder::new(vec![], Compression::default());
    let content = stream.write_all(page.content.as_bytes()).and_then(|()| stream.finish());
    let content = content.map_err(raster)?;
    let states = page.opacities.iter().enumerate();
    let states = states
        .map(|(i, (fill, stroke))| format!("/G{i} << /ca {} /CA {} >> ", number(*fill), number(*stroke)));
    let title: String = title.encode_utf16().map(|unit| format!("{unit:04X}")).collect();
    let objects: [Vec<u8>; 5] = [
        format!("<< /Producer (mckibben figure) /Title <FEFF{title}> >>").into(),
        b"<< /Type /Catalog /Pages 3 0 R >>".into(),
        b"<< /Type /Pages /Kids [4 0 R] /Count 1 >>".into(),
        format!(
            "<< /Type /Page /Parent 3 0 R /MediaBox [0 0 {} {}] /Contents 5 0 R /Resources << /ExtGState << {}>> >> >>",
            number(width),
            number(height),
            states.collect::<String>()
        )
        .into(),
        [
            format!("<< /Length {} /Filter /FlateDecode >>\nstream\n", content.len()).as_bytes(),
            &content,
            b"\nendstream",
        ]
        .concat(),
    ];
    Ok(file(&objects))
}

/// The file of numbered objects, the first of which are its information and its catalogue.
fn file(objects: &[Vec<u8>]) -> Vec<u8> {
    // Bytes beyond ASCII, so that no program takes it for text.
    let mut out = b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n".to_vec();
    let mut places = String::new();
    for (i, object) in objects.iter().enumerate() {
        // Writing into a string does not fail.
        let _ = writeln!(places, "{:010} 00000 n ", out.len());
        out.extend(format!("{} 0 obj\n", i + 1).bytes());
        out.extend(object);
        out.extend(b"\nendobj\n");
    }
    let (size, start) = (objects.len() + 1, out.len());
    let end = format!(
        "xref\n0 {size}\n0000000000 65535 f \n{places}trailer\n<< /Size {size} /Root 2 0 R /Info 1 0 R >>\nstartxref\n{start}\n%%EOF\n"
    );
    out.extend(end.bytes());
    out
}

/// What is drawn, and the pairs of opacities (fill, stroke) in it.
struct Page {
    content: String,
    opacities: Vec<(f32, f32)>,
}

impl Page {
    fn group(&mut self, group: &Group) -> Result<(), FigureError> {
        for node in group.children() {
            match node {
                Node::Group(inner) if !inner.should_isolate() => self.group(inner)?,
                Node::Path(path) if path.is_visible() => self.path(path)?,
                Node::Path(_) => {}
                Node::Group(_) | Node::Image(_) | Node::Text(_) => {
                    return Err(raster("it has pictures, texts or layers inside"));
                }
            }
        }
        Ok(())
    }

    fn path(&mut self, path: &usvg::Path) -> Result<(), FigureError> {
        self.content.push_str("q\n");
        let Transform { sx, ky, kx, sy, tx, ty } = path.abs_transform();
        if !path.abs_transform().is_identity() {
            self.operator(&[sx, ky, kx, sy, tx, ty], "cm");
        }
        let opacity = (
            path.fill().map_or(1.0, |fill| fill.opacity().get()),
            path.stroke().map_or(1.0, |stroke| stroke.opacity().get()),
        );
        if opacity != (1.0, 1.0) {
            let known = self.opacities.iter().position(|o| *o == opacity);
            let i = known.unwrap_or_else(|| {
                self.opacities.push(opacity);
                self.opacities.len() - 1
            });
            // Writing into a string does not fail.
            let _ = writeln!(self.content, "/G{i} gs");
        }
        if let Some(fill) = path.fill() {
            let colour = colour(fill.paint())?;
            self.operator(&colour, "rg");
        }
        if let Some(stroke) = path.stroke() {
            self.pen(stroke)?;
        }
        self.outline(path.data().segments());
        self.content.push_str(match (path.fill().map(Fill::rule), path.stroke()) {
            (Some(FillRule::NonZero), None) => "f\n",
            (Some(FillRule::EvenOdd), None) => "f*\n",
            (Some(FillRule::NonZero), Some(_)) => "B\n",
            (Some(FillRule::EvenOdd), Some(_)) => "B*\n",
            (None, Some(_)) => "S\n",
            (None, None) => "n\n",
        });
        self.content.push_str("Q\n");
        Ok(())
    }

    fn pen(&mut self, stroke: &Stroke) -> Result<(), FigureError> {
        let colour = colour(stroke.paint())?;
        self.operator(&colour, "RG");
        self.operator(&[stroke.width().get()], "w");
        let cap = match stroke.linecap() {
            LineCap::Butt => 0,
            LineCap::Round => 1,
            LineCap::Square => 2,
        };
        let join = match stroke.linejoin() {
            LineJoin::Miter | LineJoin::MiterClip => 0,
            LineJoin::Round => 1,
            LineJoin::Bevel => 2,
        };
        let limit = number(stroke.miterlimit().get());
        let dashes: Vec<String> = stroke.dasharray().unwrap_or_default().iter().map(|v| number(*v)).collect();
        // Writing into a string does not fail.
        let _ = writeln!(
            self.content,
            "{cap} J {join} j {limit} M [{}] {} d",
            dashes.join(" "),
            number(stroke.dashoffset())
        );
        Ok(())
    }

    fn outline(&mut self, segments: impl Iterator<Item = PathSegment>) {
        let (mut from, mut start) = (Point::zero(), Point::zero());
        for segment in segments {
            match segment {
                PathSegment::MoveTo(to) => {
                    self.operator(&[to.x, to.y], "m");
                    (from, start) = (to, to);
                }
                PathSegment::LineTo(to) => {
                    self.operator(&[to.x, to.y], "l");
                    from = to;
                }
                // PDF has cubic curves alone.
                PathSegment::QuadTo(by, to) => {
                    let towards = |end: f32, by: f32| end + 2.0 / 3.0 * (by - end);
                    let (a, b) = (
                        (towards(from.x, by.x), towards(from.y, by.y)),
                        (towards(to.x, by.x), towards(to.y, by.y)),
                    );
                    self.operator(&[a.0, a.1, b.0, b.1, to.x, to.y], "c");
                    from = to;
                }
                PathSegment::CubicTo(a, b, to) => {
                    self.operator(&[a.x, a.y, b.x, b.y, to.x, to.y], "c");
                    from = to;
                }
                PathSegment::Close => {
                    self.content.push_str("h\n");
                    from = start;
                }
            }
        }
    }

    fn operator(&mut self, numbers: &[f32], name: &str) {
        numbers.iter().for_each(|v| self.content.push_str(&(number(*v) + " ")));
        self.content.push_str(name);
        self.content.push('\n');
    }
}

fn colour(paint: &Paint) -> Result<[f32; 3], FigureError> {
    match paint {
        Paint::Color(c) => Ok([c.red, c.green, c.blue].map(|part| f32::from(part) / 255.0)),
        _ => Err(raster("it has gradients or patterns")),
    }
}

/// A number as PDF has it: no exponent, at most four decimals.
fn number(v: f32) -> String {
    let text = format!("{v:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}
