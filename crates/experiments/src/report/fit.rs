//! Growth as a power of the number of points: the line of least squares through the logarithms.

/// `factor * n^exponent`, and how far the farthest number is from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Fit {
    pub(crate) factor: f64,
    pub(crate) exponent: f64,
    /// The greatest ratio of a number to the fit or of the fit to a number: 1.2 is a fifth off.
    pub(crate) residual: f64,
}

impl Fit {
    /// The fit of numbers over points; `None` for fewer than two different numbers of points, and where a number is not
    /// positive.
    pub(crate) fn of(at: &[[f64; 2]]) -> Option<Fit> {
        let logs: Vec<[f64; 2]> = at.iter().map(|point| point.map(f64::ln)).collect();
        let count = logs.len() as f64;
        let mean = [0, 1].map(|i| logs.iter().map(|p| p[i]).sum::<f64>() / count);
        let sum = |i: usize, j: usize| -> f64 {
            logs.iter()
                .map(|p| (p[i] - mean[i]) * (p[j] - mean[j]))
                .sum()
        };
        if logs.len() < 2 || sum(0, 0) == 0.0 || !sum(0, 1).is_finite() {
            return None;
        }
        let exponent = sum(0, 1) / sum(0, 0);
        let start = mean[1] - exponent * mean[0];
        let off = logs.iter().map(|p| (p[1] - start - exponent * p[0]).abs());
        Some(Fit {
            factor: start.exp(),
            exponent,
            residual: off.fold(0.0, f64::max).exp(),
        })
    }

    /// The fit at a number of points.
    pub(crate) fn at(&self, points: f64) -> f64 {
        self.factor * points.powf(self.exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::Fit;

    #[test]
    fn powers_are_found_without_a_residual() {
        for power in [0, 1, 2] {
            let at = [10.0_f64, 100.0, 1000.0].map(|n| [n, 3.0 * n.powi(power)]);
            let fit = Fit::of(&at).expect("three sizes");
            let expected = [3.0, f64::from(power), 1.0];
            for (found, expected) in [fit.factor, fit.exponent, fit.residual]
                .into_iter()
                .zip(expected)
            {
                assert!((found - expected).abs() < 1e-9, "{fit:?}");
            }
        }
    }

    #[test]
    fn the_residual_is_the_farthest_from_the_line() {
        let fit = Fit::of(&[[1.0, 1.0], [1.0, 4.0], [2.0, 2.0], [2.0, 2.0]]).expect("two sizes");
        assert!(
            (fit.at(1.0) - 2.0).abs() < 1e-9 && (fit.residual - 2.0).abs() < 1e-9,
            "{fit:?}"
        );
    }
}
