//! The figure as PDF: the same SVG as one page of vectors of the figure's size, its texts as
//! outlines.

use crate::{
    figure::{Figure, FigureError, Result},
    outlines::tree,
};
use flate2::{Compression, write::ZlibEncoder};
use pdf_writer::{
    Content, Filter, Name, Pdf, Rect, Ref, TextStr,
    types::{LineCapStyle, LineJoinStyle},
    writers::ExtGraphicsState,
};
use resvg::{
    tiny_skia::{PathSegment, Point},
    usvg::{self, Fill, FillRule, Group, LineCap, LineJoin, Node, Paint, Stroke, Transform},
};
use std::io::Write as _;

/// Points (1/72 in) for each pixel of CSS (1/96 in).
const POINTS: f32 = 0.75;

impl Figure {
    /// The figure as a PDF page of its size.
    pub fn to_pdf(&self) -> Result<Vec<u8>> {
        render(&[self.to_svg()?], &self.title)
    }
}

/// Drawings as the pages of a PDF, each of its size.
pub fn render(svgs: &[String], title: &str) -> Result<Vec<u8>> {
    let [info, catalog, pages] = [1, 2, 3].map(Ref::new);
    let sheets = (0..svgs.len()).map(|i| Ref::new(4 + 2 * i as i32));
    let mut pdf = Pdf::new();
    pdf.document_info(info)
        .producer(TextStr("mckibben figure"))
        .title(TextStr(title));
    pdf.catalog(catalog).pages(pages);
    pdf.pages(pages)
        .kids(sheets.clone())
        .count(svgs.len() as i32);
    for (svg, sheet) in svgs.iter().zip(sheets) {
        page(&mut pdf, svg, (pages, sheet))?;
    }
    Ok(pdf.finish())
}

/// A drawing as one page of many; its content is the object behind it.
fn page(pdf: &mut Pdf, svg: &str, (pages, sheet): (Ref, Ref)) -> Result<()> {
    let tree = tree(svg)?;
    let width = tree.size().width() * POINTS;
    let height = tree.size().height() * POINTS;
    let mut drawn = Drawn {
        content: Content::new(),
        opacities: vec![],
    };
    // From pixels below the upper edge to points above the lower one.
    drawn
        .content
        .transform([POINTS, 0.0, 0.0, -POINTS, 0.0, rounded(height)]);
    drawn.group(tree.root())?;
    let mut stream = ZlibEncoder::new(vec![], Compression::default());
    let content = stream
        .write_all(&drawn.content.finish())
        .and_then(|()| stream.finish())
        .map_err(FigureError::image)?;
    let body = Ref::new(sheet.get() + 1);
    let mut page = pdf.page(sheet);
    page.parent(pages)
        .media_box(Rect::new(0.0, 0.0, rounded(width), rounded(height)))
        .contents(body);
    let mut resources = page.resources();
    let mut states = resources.ext_g_states();
    for (i, (fill, stroke)) in drawn.opacities.iter().enumerate() {
        let mut state = states
            .insert(Name(state_name(i).as_bytes()))
            .start::<ExtGraphicsState<'_>>();
        state.non_stroking_alpha(*fill).stroking_alpha(*stroke);
    }
    drop(states);
    drop(resources);
    drop(page);
    pdf.stream(body, &content).filter(Filter::FlateDecode);
    Ok(())
}

/// The content of a page, and the pairs of opacities (fill, stroke) in it.
struct Drawn {
    content: Content,
    opacities: Vec<(f32, f32)>,
}

fn state_name(i: usize) -> String {
    format!("G{i}")
}

impl Drawn {
    fn group(&mut self, group: &Group) -> Result<()> {
        for node in group.children() {
            match node {
                Node::Group(inner) if !inner.should_isolate() => self.group(inner)?,
                Node::Path(path) if path.is_visible() => self.path(path)?,
                Node::Path(_) => {}
                Node::Group(_) | Node::Image(_) | Node::Text(_) => {
                    return Err(FigureError::image(
                        "it has pictures, texts or layers inside",
                    ));
                }
            }
        }
        Ok(())
    }

    fn path(&mut self, path: &usvg::Path) -> Result<()> {
        self.content.save_state();
        let Transform {
            sx,
            ky,
            kx,
            sy,
            tx,
            ty,
        } = path.abs_transform();
        if !path.abs_transform().is_identity() {
            self.content
                .transform([sx, ky, kx, sy, tx, ty].map(rounded));
        }
        let opacity = (
            path.fill().map_or(1.0, |fill| fill.opacity().get()),
            path.stroke().map_or(1.0, |stroke| stroke.opacity().get()),
        );
        if opacity != (1.0, 1.0) {
            let known = self.opacities.iter().position(|o| *o == opacity);
            let i = known.unwrap_or(self.opacities.len());
            self.opacities.extend(known.is_none().then_some(opacity));
            self.content.set_parameters(Name(state_name(i).as_bytes()));
        }
        if let Some(fill) = path.fill() {
            let [r, g, b] = colour(fill.paint())?;
            self.content.set_fill_rgb(r, g, b);
        }
        if let Some(stroke) = path.stroke() {
            self.pen(stroke)?;
        }
        self.outline(path.data().segments());
        match (path.fill().map(Fill::rule), path.stroke()) {
            (Some(FillRule::NonZero), None) => self.content.fill_nonzero(),
            (Some(FillRule::EvenOdd), None) => self.content.fill_even_odd(),
            (Some(FillRule::NonZero), Some(_)) => self.content.fill_nonzero_and_stroke(),
            (Some(FillRule::EvenOdd), Some(_)) => self.content.fill_even_odd_and_stroke(),
            (None, Some(_)) => self.content.stroke(),
            (None, None) => self.content.end_path(),
        };
        self.content.restore_state();
        Ok(())
    }

    fn pen(&mut self, stroke: &Stroke) -> Result<()> {
        let [r, g, b] = colour(stroke.paint())?;
        let cap = match stroke.linecap() {
            LineCap::Butt => LineCapStyle::ButtCap,
            LineCap::Round => LineCapStyle::RoundCap,
            LineCap::Square => LineCapStyle::ProjectingSquareCap,
        };
        let join = match stroke.linejoin() {
            LineJoin::Miter | LineJoin::MiterClip => LineJoinStyle::MiterJoin,
            LineJoin::Round => LineJoinStyle::RoundJoin,
            LineJoin::Bevel => LineJoinStyle::BevelJoin,
        };
        let dashes = stroke
            .dasharray()
            .unwrap_or_default()
            .iter()
            .copied()
            .map(rounded);
        self.content
            .set_stroke_rgb(r, g, b)
            .set_line_width(rounded(stroke.width().get()))
            .set_line_cap(cap)
            .set_line_join(join)
            .set_miter_limit(rounded(stroke.miterlimit().get()))
            .set_dash_pattern(dashes, rounded(stroke.dashoffset()));
        Ok(())
    }

    fn outline(&mut self, segments: impl Iterator<Item = PathSegment>) {
        let mut from = Point::zero();
        let mut start = Point::zero();
        for segment in segments {
            match segment {
                PathSegment::MoveTo(to) => {
                    self.content.move_to(place(to.x), place(to.y));
                    (from, start) = (to, to);
                }
                PathSegment::LineTo(to) => {
                    self.content.line_to(place(to.x), place(to.y));
                    from = to;
                }
                // PDF has cubic curves alone.
                PathSegment::QuadTo(by, to) => {
                    let part = |end: f32, by: f32| end + 2.0 / 3.0 * (by - end);
                    let towards = |end: Point| Point::from_xy(part(end.x, by.x), part(end.y, by.y));
                    self.curve(towards(from), towards(to), to);
                    from = to;
                }
                PathSegment::CubicTo(a, b, to) => {
                    self.curve(a, b, to);
                    from = to;
                }
                PathSegment::Close => {
                    self.content.close_path();
                    from = start;
                }
            }
        }
    }

    fn curve(&mut self, a: Point, b: Point, to: Point) {
        let [x1, y1, x2, y2, x3, y3] = [a.x, a.y, b.x, b.y, to.x, to.y].map(place);
        self.content.cubic_to(x1, y1, x2, y2, x3, y3);
    }
}

fn colour(paint: &Paint) -> Result<[f32; 3]> {
    match paint {
        Paint::Color(c) => {
            Ok([c.red, c.green, c.blue].map(|part| rounded(f32::from(part) / 255.0)))
        }
        _ => Err(FigureError::image("it has gradients or patterns")),
    }
}

/// At most four decimals.
fn rounded(v: f32) -> f32 {
    (v * 1e4).round() / 1e4
}

/// A coordinate to 2.6 µm: texts are outlines, and most of a file.
fn place(v: f32) -> f32 {
    (v * 1e2).round() / 1e2
}
