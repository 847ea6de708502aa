//! Which of the known words somebody meant.

/// The candidate closest to `word` by edit distance, where it is close enough to be a slip of the
/// hand: at most two edits, or a third of the word; one inside the other (`thickness`,
/// `wall_thickness`) counts too. Case does not matter.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // Nobody mistypes a word into a novel; and the distance takes length² steps.
    if word.chars().count() > 60 {
        return None;
    }
    let word = word.trim().to_lowercase();
    let allowed = (word.chars().count() / 3).max(2);
    candidates
        .into_iter()
        .filter_map(|c| {
            let lower = c.to_lowercase();
            let edits = strsim::osa_distance(&word, &lower);
            let inside = word.len().min(lower.len()) >= 3
                && (lower.contains(&word) || word.contains(&lower));
            let close = edits <= allowed && edits < lower.chars().count();
            (close || inside).then_some((edits, c))
        })
        .min_by_key(|&(edits, _)| edits)
        .map(|(_, c)| c)
}

/// The word that was probably meant, behind a message: ` (did you mean rubber?)`; nothing where
/// none is near.
pub fn meant(nearest: Option<&str>) -> String {
    nearest.map_or_else(String::new, |name| format!(" (did you mean {name}?)"))
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn slips_are_recognised_and_other_words_are_not() {
        let keys = ["outer_diameter", "wall_thickness", "length", "rubber"];
        assert_eq!(nearest("outer_diamter", keys), Some("outer_diameter"));
        assert_eq!(nearest("thickness", keys), Some("wall_thickness"));
        assert_eq!(nearest("Lenght", keys), Some("length"));
        assert_eq!(nearest("temperature", keys), None);
        assert_eq!(nearest("", keys), None);
        assert_eq!(nearest("beta", ["a", "b"]), None);
    }
}
