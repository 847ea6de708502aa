//! From a name to a law: its constants follow from the stretches that a muscle reaches, without
//! steps.

use super::{LibraryError, RubberEntry, RubberFit, Standing, WindowLaw, entry, hardness};
use crate::rubber::{Law, Rubber};

/// Stretch for which a law is meant where there is no muscle: that of the prototype
/// ([`Muscle::reach`](crate::muscle::Muscle::reach)).
pub const USUAL_REACH: f64 = 1.9662;
/// By how much data should reach farther than the ideal muscle does. Strands that stretch let the
/// wall go on: in finite elements at free contraction, on the braid `antonelli2018` at θ0 20° to 35° and
/// walls of 1 to 5 mm, the largest stretch is 1 to 51 % below the reach at 1 and 2 bar, 10 % below
/// to 5 % above it at 4 bar, and 4 to 11 % above at 8 bar.
pub const COVERING: f64 = 1.05;

/// The rubber `name` or `name:law` as the prototype would have it; a muscle that is made of it
/// takes the law for its own stretches ([`Muscle::new`](crate::muscle::Muscle::new)). Its name is
/// the one it can be found by.
///
/// # Errors
/// [`LibraryError`] with the nearest name, or the laws the rubber has.
pub fn find(name: &str) -> Result<Rubber, LibraryError> {
    find_for(name, USUAL_REACH)
}

/// The rubber `name` or `name:law` for stretches up to `reach`: see the module on which fit that
/// is.
pub fn find_for(name: &str, reach: f64) -> Result<Rubber, LibraryError> {
    find_up_to(name, COVERING * reach)
}

/// The same from data up to a stretch.
pub fn find_up_to(name: &str, stretch: f64) -> Result<Rubber, LibraryError> {
    if let Some(rubber) = hardness::find(name) {
        return rubber.map(|(rubber, _)| rubber);
    }
    let (plain, law) = match name.split_once(':') {
        Some((plain, law)) => (plain, Some(law)),
        None => (name, None),
    };
    let entry = entry(plain)?;
    let law = law.map(super::plain);
    let fit = entry.up_to(law.as_deref(), stretch).ok_or_else(|| {
        LibraryError(format!(
            "{} has no fit of the law \"{:.60}\"; it has {}",
            entry.name,
            law.as_deref().unwrap_or(""),
            entry.laws().join(", ")
        ))
    })?;
    Ok(entry.rubber(law.as_deref(), fit))
}

/// A rubber as a muscle that reaches `reach` has it: one of the library with the law for these
/// stretches, any other as it is. A rubber is of the library if name and constants are; with a
/// constant changed it no longer is.
pub fn following(rubber: Rubber, reach: f64) -> Rubber {
    // The rubber of most muscles has one law: for it the library need not be read.
    if rubber.name.is_none() || rubber == Rubber::paper() {
        return rubber;
    }
    library_entry(&rubber)
        .and_then(|(entry, law)| Some(entry.rubber(law, entry.up_to(law, COVERING * reach)?)))
        .unwrap_or(rubber)
}

/// Entry and law of a rubber of the library, with its constants.
fn library_entry(rubber: &Rubber) -> Option<(&'static RubberEntry, Option<&str>)> {
    exactly(rubber.name.as_deref()?).filter(|(entry, law)| entry.has(*law, rubber))
}

/// Whether a rubber is one of the library whose law follows the muscle.
pub fn follows(rubber: &Rubber) -> bool {
    library_entry(rubber).is_some_and(|(entry, law)| entry.fits_of_law(law).nth(1).is_some())
}

/// Factor within which the stiffness of a rubber is known: of one that represents others, or
/// follows from one number of a data sheet, or has constants of which nobody says from which data
/// they are; 1 of any other.
pub fn stiffness_factor(rubber: &Rubber) -> f64 {
    /// The logarithm of the modulus then has a standard deviation of 0.35.
    const GUESSED: f64 = 1.776;
    let by_hardness = rubber.name.as_deref().and_then(hardness::find);
    if let Some(Ok((named, factor))) = by_hardness
        && named.law == rubber.law
    {
        return factor;
    }
    match library_entry(rubber) {
        Some((entry, _)) => entry.factor,
        None if rubber.fitted_to_stretch.is_some() => 1.0,
        None => GUESSED,
    }
}

/// Strain at which a strip of a rubber breaks: as stated, or by its name.
pub fn elongation_at_break(rubber: &Rubber) -> Option<f64> {
    rubber
        .elongation_at_break
        .or_else(|| exactly(rubber.name.as_deref()?)?.0.max_strain)
}

/// A rubber that keeps its law in every muscle: without its name, and with what the name says of
/// when it breaks.
pub fn without_name(rubber: Rubber) -> Rubber {
    Rubber {
        elongation_at_break: elongation_at_break(&rubber),
        name: None,
        ..rubber
    }
}

/// Entry and law of a name that the library itself gave.
fn exactly(name: &str) -> Option<(&'static RubberEntry, Option<&str>)> {
    let (plain, law) = name
        .split_once(':')
        .map_or((name, None), |(plain, law)| (plain, Some(law)));
    Some((
        super::entries().ok()?.iter().find(|e| e.name == plain)?,
        law,
    ))
}

/// A fit of a rubber.
pub struct LibraryFit {
    pub law: Law,
    /// Largest stretch of the data.
    pub fitted_to_stretch: Option<f64>,
}

impl RubberEntry {
    /// Names of the laws that can be chosen, each once; `ogden-2` beside `ogden`, which is the best
    /// of them.
    pub fn laws(&self) -> Vec<String> {
        let mut laws: Vec<String> = vec![];
        let fits = self
            .fits
            .iter()
            .filter(|_| self.windows.is_empty())
            .map(|f| f.law.name().to_owned());
        let fitted = self
            .windows
            .iter()
            .flat_map(|w| &w.laws)
            .map(|l| l.name.clone());
        for name in fits.chain(fitted) {
            if !laws.contains(&name) {
                laws.push(name);
            }
        }
        laws.sort_by_key(|name| order(name));
        laws
    }

    /// The fit to data up to a stretch: that of the smallest range which covers it, and between the
    /// ends of two ranges constants between theirs, in proportion. Of a law that is linear in its
    /// constants the energy lies between the two. Beyond all data the fit to all.
    pub(super) fn up_to(&self, law: Option<&str>, stretch: f64) -> Option<LibraryFit> {
        let mut lower: Option<LibraryFit> = None;
        for mut fit in self.fits_of_law(law) {
            let end = fit.fitted_to_stretch;
            if let Some((end, (lower, start))) =
                end.zip(lower.and_then(|l| Some((l.law, l.fitted_to_stretch?))))
                && start < stretch
                && stretch < end
            {
                fit.law = lower.towards(&fit.law, (stretch - start) / (end - start));
                fit.fitted_to_stretch = Some(stretch);
            }
            if end.is_none_or(|end| end >= stretch) {
                return Some(fit);
            }
            lower = Some(fit);
        }
        lower
    }

    /// Whether a rubber of this name has the constants that the library gives it.
    fn has(&self, law: Option<&str>, rubber: &Rubber) -> bool {
        let fit = self.up_to(law, rubber.fitted_to_stretch.unwrap_or(1.0));
        fit.is_some_and(|fit| self.rubber(law, fit) == *rubber)
    }

    /// The fits of a law, or those that the name alone means, from the smallest range to the
    /// widest.
    pub(super) fn fits_of_law(&self, law: Option<&str>) -> impl Iterator<Item = LibraryFit> {
        // Without a curve: the first law of the table, which for the silicones is the neo-Hookean
        // one.
        let published = law.or_else(|| self.published_default()).map(str::to_owned);
        let published = self
            .fits
            .iter()
            .filter(|_| self.windows.is_empty())
            .filter(move |f| Some(f.law.name()) == published.as_deref())
            .map(|f| LibraryFit {
                law: f.law.clone(),
                fitted_to_stretch: self.reach(f).map(|strain| 1.0 + strain),
            });
        let name = match law {
            Some(law) => self.name_in_windows(|l| l.name == law || l.law.name() == law),
            None => self.usual_law.as_ref(),
        };
        let fitted = self.windows.iter().filter_map(move |w| {
            Some(LibraryFit {
                law: w.laws.iter().find(|l| Some(&l.name) == name)?.law.clone(),
                fitted_to_stretch: Some(w.fitted_to_stretch),
            })
        });
        published.chain(fitted)
    }

    /// The law of all ranges, with the number of its terms: of those that are meant the one that is
    /// recommended, or of equal standing, in most of them.
    pub(super) fn name_in_windows(&self, is_meant: impl Fn(&WindowLaw) -> bool) -> Option<&String> {
        let laws = || self.windows.iter().flat_map(|w| &w.laws);
        let count = |name: &String, counts: fn(&WindowLaw) -> bool| {
            laws().filter(|l| l.name == *name && counts(l)).count()
        };
        laws()
            .filter(|l| is_meant(l))
            .map(|l| &l.name)
            .max_by_key(|name| {
                (
                    count(name, |l| l.standing != Standing::Behind),
                    count(name, |l| l.standing == Standing::Recommended),
                    count(name, |_| true),
                )
            })
    }

    /// The law that the name of a rubber without a curve means: of all fits to one axis the one
    /// that can be trusted in two.
    fn published_default(&self) -> Option<&'static str> {
        let laws = || self.fits.iter().map(|f| f.law.name());
        laws()
            .find(|law| *law == "neo-hookean")
            .or_else(|| laws().next())
    }

    /// Engineering strain to which a published fit has data behind it: rubber may fail before the
    /// range ends.
    pub fn reach(&self, fit: &RubberFit) -> Option<f64> {
        fit.up_to_strain
            .map(|strain| self.max_strain.map_or(strain, |max| strain.min(max)))
    }

    pub(super) fn rubber(&self, law: Option<&str>, fit: LibraryFit) -> Rubber {
        // Where the name alone always means this law it says enough.
        let named =
            law.filter(|law| !self.windows.is_empty() || self.published_default() != Some(*law));
        Rubber {
            name: Some(
                named.map_or_else(|| self.name.clone(), |law| format!("{}:{law}", self.name)),
            ),
            fitted_to_stretch: fit.fitted_to_stretch,
            ..Rubber::new(fit.law)
        }
    }
}

/// Place of a law among all: sums of terms by their number.
fn order(name: &str) -> usize {
    crate::rubber::Form::all()
        .iter()
        .position(|f| f.name() == name)
        .unwrap_or(usize::MAX)
}
