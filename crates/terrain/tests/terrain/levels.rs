//! Levels.

use num_rational::BigRational;
use sweep_cdt_terrain::{LevelsError, levels};

fn number(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

#[test]
fn levels_are_the_multiples_between_two_heights() {
    let between = |from, every, range| levels(&from, &every, range);
    let expected = Ok(vec![350.0, 400.0, 450.0]);
    assert_eq!(
        between(number(0, 1), number(50, 1), [309.37, 450.0]),
        expected
    );
    let expected = Ok(vec![-2.5, 0.5, 3.5]);
    assert_eq!(between(number(7, 2), number(3, 1), [-3.0, 4.0]), expected);
    assert_eq!(between(number(0, 1), number(7, 1), [1.0, 6.0]), Ok(vec![]));
}

/// A third of a tenth less than 0.3 in doubles that add up; here each multiple is what its text says.
#[test]
fn levels_are_what_their_texts_say() {
    let found = levels(&number(0, 1), &number(1, 10), [0.0, 1.0]);
    let expected = vec![0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0];
    assert_eq!(found, Ok(expected));
}

#[test]
fn too_many_levels_and_none_apart_are_refused() {
    let zero = || number(0, 1);
    let found = levels(&zero(), &zero(), [0.0, 1.0]);
    assert_eq!(found, Err(LevelsError::NotPositive));
    let found = levels(&zero(), &number(-1, 1), [0.0, 1.0]);
    assert_eq!(found, Err(LevelsError::NotPositive));
    let found = levels(&zero(), &number(1, 1000), [-1e300, 1e300]);
    assert_eq!(found, Err(LevelsError::TooMany));
    let found = levels(&zero(), &number(1, 1), [0.0, 1_000_001.0]);
    assert_eq!(found, Err(LevelsError::TooMany));
    let found = levels(&zero(), &number(1, 1), [f64::MAX, f64::MAX]);
    assert_eq!(found, Ok(vec![f64::MAX]));
}
