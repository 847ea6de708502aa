//! A scene as SVG: the pieces from far to near, a bar of colours, a bar of length.

use super::body::Scene;
use super::camera::{Camera, Piece, Seen, pieces};
use crate::font::{FAMILY, Metrics};
use crate::sizes::{CAPTION, PER_MM, TITLE};
use crate::svg::{INK, SOFT, text};
use crate::ticks::{self, Scale};
use crate::xml::{escape, length as n};
use crate::{FigureError, palette};
use std::fmt::Write as _;

const MARGIN: f64 = 16.0;
const BAR: f64 = 10.0;

pub(super) fn svg(scene: &Scene) -> Result<String, FigureError> {
    check(scene)?;
    let metrics = Metrics::new()?;
    let width = scene.width_mm * PER_MM;
    let pieces = pieces(scene);
    let bounds = Bounds::of(&pieces).ok_or_else(|| FigureError::NoPanels { title: scene.title.clone() })?;
    let inner = width - 2.0 * MARGIN;
    let factor = inner / bounds.width().max(1e-9);
    let title = metrics.wrap(&scene.title, TITLE, inner);
    let caption = metrics.wrap(&scene.caption, CAPTION, inner);
    let top = 10.0 + title.len() as f64 * (TITLE + 4.0) + 8.0;
    let bottom = top + bounds.height() * factor;
    let has_values = scene.faces.iter().any(|f| f.values.is_some());
    let bars = 58.0;
    let height = bottom + bars + caption.len() as f64 * 12.0 + 8.0;
    let height_mm = height / PER_MM;
    if !(20.0..=2000.0).contains(&scene.width_mm) || !(20.0..=2000.0).contains(&height_mm) {
        return Err(FigureError::PaperSize { width_mm: scene.width_mm, height_mm });
    }
    let values = scene.faces.iter().filter_map(|f| f.values).flatten();
    let scale = ticks::scale(&scene.values, ticks::extent(values), 5)?;
    let on_paper =
        |p: &Seen| (MARGIN + (p[0] - bounds.low[0]) * factor, bottom - (p[1] - bounds.low[1]) * factor);

    let mut out = String::new();
    let _ = write!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {} {}\" \
         font-family=\"{FAMILY}\" role=\"img\" aria-label=\"{}\">\n<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n",
        n(scene.width_mm),
        n(height_mm),
        n(width),
        n(height),
        escape(&scene.title),
        n(width),
        n(height)
    );
    for (i, line) in title.iter().enumerate() {
        let extra = format!(" stroke=\"{INK}\" stroke-width=\"0.35\"");
        let y = 10.0 + TITLE / 2.0 + i as f64 * (TITLE + 4.0);
        text(&mut out, (MARGIN, y), TITLE, INK, "start", &extra, line);
    }
    out.push_str("<g stroke-linejoin=\"round\" stroke-linecap=\"round\" fill=\"none\">\n");
    for piece in &pieces {
        match piece {
            Piece::Patch { corners, value, light } => {
                let colour = shaded(value.map(|v| scale.part(v)), *light);
                let mut d = String::new();
                for (i, corner) in corners.iter().enumerate() {
                    let (x, y) = on_paper(corner);
                    let _ = write!(d, "{}{} {}", if i == 0 { "M" } else { "L" }, n(x), n(y));
                }
                // The stroke closes the hair between neighbours.
                let _ = writeln!(
                    out,
                    "<path d=\"{d}Z\" fill=\"{colour}\" stroke=\"{colour}\" stroke-width=\"0.4\"/>"
                );
            }
            Piece::Part { ends, width_mm } => {
                let ((x0, y0), (x1, y1)) = (on_paper(&ends[0]), on_paper(&ends[1]));
                let _ = writeln!(
                    out,
                    "<path d=\"M{} {}L{} {}\" stroke=\"#1d1d1d\" stroke-width=\"{}\"/>",
                    n(x0),
                    n(y0),
                    n(x1),
                    n(y1),
                    n(width_mm * PER_MM)
                );
            }
        }
    }
    out.push_str("</g>\n");
    if has_values {
        colour_bar(&mut out, scene, &scale, (MARGIN + 8.0, bottom + 14.0), 0.55 * inner);
    }
    length_bar(&mut out, scene, factor, (width - MARGIN, bottom + 14.0), 0.3 * inner);
    for (i, line) in caption.iter().enumerate() {
        text(&mut out, (MARGIN, bottom + bars + i as f64 * 12.0), CAPTION, SOFT, "start", "", line);
    }
    out.push_str("</svg>\n");
    Ok(out)
}

fn check(scene: &Scene) -> Result<(), FigureError> {
    let wrong = |what| Err(FigureError::NotFinite { title: scene.title.clone(), what });
    let places =
        scene.faces.iter().flat_map(|f| f.corners).chain(scene.threads.iter().flat_map(|t| t.points.clone()));
    if places.flatten().any(|x| !x.is_finite()) {
        return wrong("a place");
    }
    if scene.faces.iter().filter_map(|f| f.values).flatten().any(|v| !v.is_finite()) {
        return wrong("a value");
    }
    Ok(())
}

/// Smallest rectangle around everything.
struct Bounds {
    low: [f64; 2],
    high: [f64; 2],
}

impl Bounds {
    fn of(pieces: &[Piece]) -> Option<Self> {
        let mut b = Self { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };
        let mut faces = false;
        let mut add = |p: &Seen| {
            for ((low, high), x) in b.low.iter_mut().zip(&mut b.high).zip(p) {
                *low = low.min(*x);
                *high = high.max(*x);
            }
        };
        for piece in pieces {
            match piece {
                Piece::Patch { corners, .. } => {
                    faces = true;
                    corners.iter().for_each(&mut add);
                }
                Piece::Part { ends, .. } => ends.iter().for_each(&mut add),
            }
        }
        faces.then_some(b)
    }

    fn width(&self) -> f64 {
        self.high[0] - self.low[0]
    }

    fn height(&self) -> f64 {
        self.high[1] - self.low[1]
    }
}

/// Colour of a part of the range; grey where there is none.
fn shaded(part: Option<f64>, light: f64) -> String {
    let rgb = part.map_or([0xB8, 0xBC, 0xC2], palette::of_part);
    let [r, g, b] = rgb.map(|c| (f64::from(c) * light).round().clamp(0.0, 255.0) as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn colour_bar(out: &mut String, scene: &Scene, scale: &Scale, (x, y): (f64, f64), w: f64) {
    const STEPS: usize = 60;
    for i in 0..STEPS {
        let colour = shaded(Some((i as f64 + 0.5) / STEPS as f64), 1.0);
        let step = w / STEPS as f64;
        let _ = writeln!(
            out,
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{colour}\"/>",
            n(x + i as f64 * step),
            n(y),
            n(step + 0.3),
            n(BAR)
        );
    }
    for (v, label) in scale.ticks.iter().zip(&scale.labels) {
        text(out, (x + scale.part(*v) * w, y + BAR + 7.0), CAPTION, INK, "middle", "", label);
    }
    let label = if scale.exponent == 0 {
        scene.values.label.clone()
    } else {
        format!("{}, × {}", scene.values.label, ticks::power_text(scale.exponent))
    };
    text(out, (x + 0.5 * w, y + BAR + 19.0), CAPTION + 1.0, INK, "middle", "", &label);
}

/// A bar whose length is 1, 2 or 5 times a power of ten, along the body's z axis as it is seen.
fn length_bar(out: &mut String, scene: &Scene, factor: f64, (right, y): (f64, f64), room: f64) {
    let along = Camera::new(scene.view).see([0.0, 0.0, 1.0])[0].abs() * factor;
    if along <= 0.0 || !along.is_finite() {
        return;
    }
    let most = room / along;
    let power = 10f64.powf(most.log10().floor());
    let size = [5.0, 2.0, 1.0].into_iter().map(|d| d * power).find(|s| *s <= most).unwrap_or(power);
    let w = size * along;
    let _ = writeln!(
        out,
        "<path d=\"M{} {}v6M{} {}h{}m0 -3v6\" stroke=\"{INK}\" stroke-width=\"1.2\" fill=\"none\"/>",
        n(right - w),
        n(y + 2.0),
        n(right - w),
        n(y + 5.0),
        n(w)
    );
    let label = format!("{} {} along the axis", ticks::number(size), scene.length_unit);
    text(out, (right, y + BAR + 7.0), CAPTION, INK, "end", "", &label);
}
