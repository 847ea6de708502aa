//! The order of items by a number of each, NaN last.

/// A list sorted by a number of each item.
pub trait SortByNumber<T> {
    /// Sorts it; items with equal numbers stay in their order.
    fn sort_by_number(&mut self, number: impl FnMut(&T) -> f64);
}

impl<T> SortByNumber<T> for [T] {
    fn sort_by_number(&mut self, number: impl FnMut(&T) -> f64) {
        // One sort is compiled for all lists: that of the places where the items come from.
        let numbers: Vec<f64> = self.iter().map(number).collect();
        let mut from = places(&numbers);
        for first in 0..from.len() {
            let mut place = first;
            while from[place] != first {
                let next = from[place];
                self.swap(place, next);
                from[place] = place;
                place = next;
            }
            from[place] = place;
        }
    }
}

/// Places of numbers from the lowest to the highest.
fn places(numbers: &[f64]) -> Vec<usize> {
    let mut places = Vec::from_iter(0..numbers.len());
    places.sort_by(|&a, &b| numbers[a].total_cmp(&numbers[b]));
    places
}

/// The first lowest and the last highest of items, by a number of each.
pub trait ByNumber: Iterator + Sized {
    /// The item with the lowest number.
    fn min_by_number(self, number: impl Fn(&Self::Item) -> f64) -> Option<Self::Item> {
        self.min_by(|a, b| number(a).total_cmp(&number(b)))
    }

    /// The item with the highest number.
    fn max_by_number(self, number: impl Fn(&Self::Item) -> f64) -> Option<Self::Item> {
        self.max_by(|a, b| number(a).total_cmp(&number(b)))
    }
}

impl<I: Iterator> ByNumber for I {}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The standard library's stable sort and extremes give the same.
        #[test]
        fn items_come_as_the_standard_library_orders_them(numbers in prop::collection::vec(-3_i8..4, 0..40)) {
            let items: Vec<(f64, usize)> = numbers.iter().map(|n| f64::from(*n)).zip(0..).collect();
            let mut expected = items.clone();
            expected.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut sorted = items.clone();
            sorted.sort_by_number(|item| item.0);
            prop_assert_eq!(&sorted, &expected);
            prop_assert_eq!(items.iter().min_by_number(|item| item.0), expected.first());
            prop_assert_eq!(items.iter().max_by_number(|item| item.0), expected.last());
        }
    }
}
