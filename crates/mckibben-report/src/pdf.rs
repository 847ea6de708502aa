//! Drawings as the pages of a PDF: vectors, and real text in the embedded font.

use crate::{
    drawing::{Drawing, Item, PALE, Paint, Shape, Text},
    figure::{Figure, FigureError, Result},
    font::Metrics,
    png::traced,
    rect::PER_MM,
};
use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::{
    Content, Filter, Name, Pdf, Rect, Ref, Str, TextStr,
    types::{
        CidFontType, FontFlags, LineCapStyle, LineJoinStyle, SystemInfo, TextRenderingMode,
        UnicodeCmap,
    },
    writers::ExtGraphicsState,
};
use std::collections::BTreeMap;
use subsetter::GlyphRemapper;
use tiny_skia::PathSegment::{Close, CubicTo, LineTo, MoveTo, QuadTo};

/// Points (1/72 in) for each unit of a drawing.
const POINTS: f64 = 72.0 / 25.4 / PER_MM;

const FONT: Name<'_> = Name(b"F");
const FONT_NAME: Name<'_> = Name(b"MCKIBB+DejaVuSans");
/// State of pale areas.
const PALE_AREA: Name<'_> = Name(b"P");
const SYSTEM: SystemInfo<'_> = SystemInfo {
    registry: Str(b"Adobe"),
    ordering: Str(b"Identity"),
    supplement: 0,
};

impl Figure {
    /// The figure as a PDF page of its size.
    pub fn to_pdf(&self) -> Result<Vec<u8>> {
        render(&[&self.drawing()?], &self.title)
    }
}

/// Drawings as the pages of a PDF, each of its size.
pub fn render(drawings: &[&Drawing], title: &str) -> Result<Vec<u8>> {
    let [info, catalog, pages, font] = [1, 2, 3, 4].map(Ref::new);
    // Behind the five objects of the font.
    let sheets = (0..drawings.len()).map(|i| Ref::new(9 + 2 * i as i32));
    let mut pdf = Pdf::new();
    pdf.document_info(info)
        .producer(TextStr("mckibben figure"))
        .title(TextStr(title));
    pdf.catalog(catalog).pages(pages);
    let mut all = pdf.pages(pages);
    all.kids(sheets.clone()).count(drawings.len() as i32);
    let mut resources = all.resources();
    resources.fonts().pair(FONT, font);
    resources
        .ext_g_states()
        .insert(PALE_AREA)
        .start::<ExtGraphicsState<'_>>()
        .non_stroking_alpha(PALE as f32);
    drop(resources);
    drop(all);
    let mut writer = Writer {
        content: Content::new(),
        metrics: Metrics::new()?,
        glyphs: GlyphRemapper::new(),
        chars: BTreeMap::new(),
    };
    for (drawing, sheet) in drawings.iter().zip(sheets) {
        let [width, height] = [drawing.width, drawing.height].map(|side| fine(side * POINTS));
        // From units below the upper edge to points above the lower one.
        let points = POINTS as f32;
        writer
            .content
            .transform([points, 0.0, 0.0, -points, 0.0, height])
            .set_line_cap(LineCapStyle::RoundCap)
            .set_line_join(LineJoinStyle::RoundJoin)
            .set_fill_gray(1.0)
            .rect(0.0, 0.0, fine(drawing.width), fine(drawing.height))
            .fill_nonzero();
        writer.items(&drawing.items);
        let content = std::mem::replace(&mut writer.content, Content::new());
        let content = deflated(&content.finish());
        let body = Ref::new(sheet.get() + 1);
        pdf.page(sheet)
            .parent(pages)
            .media_box(Rect::new(0.0, 0.0, width, height))
            .contents(body);
        pdf.stream(body, &content).filter(Filter::FlateDecode);
    }
    writer.font(&mut pdf, font)?;
    Ok(pdf.finish())
}

fn deflated(data: &[u8]) -> Vec<u8> {
    compress_to_vec_zlib(data, 6)
}

/// The content of a page, and what is used of the embedded font.
struct Writer {
    content: Content,
    metrics: Metrics,
    glyphs: GlyphRemapper,
    /// A character of each glyph.
    chars: BTreeMap<u16, char>,
}

impl Writer {
    /// The numbers of the glyphs of a text.
    fn encoded(&mut self, words: &str) -> Vec<u8> {
        let mut number = |c: char| {
            let glyph = self.glyphs.remap(self.metrics.glyph(c).0);
            self.chars.insert(glyph, c);
            glyph.to_be_bytes()
        };
        words.chars().flat_map(&mut number).collect()
    }

    /// Writes the five objects of the font: with the outlines of its used glyphs, and with the
    /// characters that they stand for, so that a reader can search and copy.
    fn font(&self, pdf: &mut Pdf, font: Ref) -> Result<()> {
        let [cid, descriptor, file, characters] = [1, 2, 3, 4].map(|i| Ref::new(font.get() + i));
        pdf.type0_font(font)
            .base_font(FONT_NAME)
            .encoding_predefined(Name(b"Identity-H"))
            .descendant_font(cid)
            .to_unicode(characters);
        let mut numbered = pdf.cid_font(cid);
        numbered
            .subtype(CidFontType::Type2)
            .base_font(FONT_NAME)
            .system_info(SYSTEM)
            .font_descriptor(descriptor)
            .cid_to_gid_map_predefined(Name(b"Identity"));
        let mut widths = numbered.widths();
        let mut cmap = UnicodeCmap::new(Name(b"Unicode"), SYSTEM);
        for (glyph, c) in &self.chars {
            widths.consecutive(*glyph, [fine(self.metrics.advance(*c, 1000.0))]);
            cmap.pair(*glyph, *c);
        }
        drop(widths);
        drop(numbered);
        pdf.font_descriptor(descriptor)
            .name(FONT_NAME)
            .flags(FontFlags::SYMBOLIC)
            .bbox(Rect::new(-1021.0, -463.0, 1793.0, 1232.0))
            .italic_angle(0.0)
            .ascent(928.0)
            .descent(-236.0)
            .cap_height(729.0)
            .stem_v(80.0)
            .font_file2(file);
        let outlines = subsetter::subset(self.metrics.font.raw_face().data, 0, &self.glyphs);
        let outlines = deflated(&outlines.map_err(FigureError::image)?);
        pdf.stream(file, &outlines).filter(Filter::FlateDecode);
        let cmap = deflated(&cmap.finish());
        pdf.cmap(characters, &cmap).filter(Filter::FlateDecode);
        Ok(())
    }

    fn items(&mut self, items: &[Item]) {
        for item in items {
            self.content.save_state();
            match item {
                Item::Path(shapes, paint) => self.path(shapes, paint),
                Item::Text(text) => self.text(text),
                Item::Group((x, y), scale, items) => {
                    let [x, y, scale] = [*x, *y, *scale].map(fine);
                    self.content.transform([scale, 0.0, 0.0, scale, x, y]);
                    self.items(items);
                }
            }
            self.content.restore_state();
        }
    }

    fn paint(&mut self, paint: &Paint) {
        if paint.is_pale {
            self.content.set_parameters(PALE_AREA);
        }
        if let Some(colour) = paint.fill {
            let [r, g, b] = colour.map(share);
            self.content.set_fill_rgb(r, g, b);
        }
        let Some(colour) = paint.stroke else {
            return;
        };
        let [r, g, b] = colour.map(share);
        self.content
            .set_stroke_rgb(r, g, b)
            .set_line_width(fine(paint.width));
        if !paint.dashes.is_empty() {
            self.content
                .set_line_cap(LineCapStyle::ButtCap)
                .set_dash_pattern(paint.dashes.iter().map(|length| *length as f32), 0.0);
        }
    }

    fn path(&mut self, shapes: &[Shape], paint: &Paint) {
        self.paint(paint);
        let segments = traced(shapes).finish();
        for segment in segments.iter().flat_map(|path| path.segments()) {
            match segment {
                MoveTo(to) => self.content.move_to(place(to.x), place(to.y)),
                LineTo(to) => self.content.line_to(place(to.x), place(to.y)),
                CubicTo(a, b, to) => {
                    let [a, b, to] = [a, b, to].map(|p| [p.x, p.y].map(place));
                    self.content.cubic_to(a[0], a[1], b[0], b[1], to[0], to[1])
                }
                // No shape has a quadratic curve.
                QuadTo(..) | Close => self.content.close_path(),
            };
        }
        match (paint.fill, paint.stroke) {
            (Some(_), Some(_)) => self.content.fill_nonzero_and_stroke(),
            (Some(_), None) => self.content.fill_nonzero(),
            (None, _) => self.content.stroke(),
        };
    }

    fn text(&mut self, text: &Text) {
        self.paint(&text.paint);
        if text.is_ground() {
            // Its words are those of the text above it.
            self.content
                .begin_marked_content_with_properties(Name(b"Span"))
                .properties()
                .actual_text(TextStr(""));
        }
        let (x, y) = self.metrics.start(text);
        let (u, v) = text.at;
        let matrix = match text.is_upright {
            false => [1.0, 0.0, 0.0, -1.0, x, y],
            true => [0.0, -1.0, -1.0, 0.0, u, v - x + u],
        };
        let words = self.encoded(&text.words);
        self.content
            .begin_text()
            .set_font(FONT, fine(text.size))
            .set_text_matrix(matrix.map(fine));
        if text.paint.stroke.is_some() {
            self.content
                .set_text_rendering_mode(TextRenderingMode::FillStroke);
        }
        self.content.show(Str(&words)).end_text();
        if text.is_ground() {
            self.content.end_marked_content();
        }
    }
}

/// A part of a colour.
fn share(part: u8) -> f32 {
    fine(f64::from(part) / 255.0)
}

/// At most four decimals.
fn fine(v: f64) -> f32 {
    ((v * 1e4).round() / 1e4) as f32
}

/// A coordinate to 2.5 µm.
fn place(v: f32) -> f32 {
    (v * 1e2).round() / 1e2
}
