//! Predicates and sizes that a scalar leaves to another one with all its values. Cost: a conversion of 6 or 8 numbers.
//! Why it is right: the points are converted exactly, or all by one positive factor, which changes no sign.

/// Writes functions of a [`Scalar`](super::Scalar): `signs` by those with stages, `predicates` and `sizes` by those of
/// another type.
macro_rules! forward {
    (signs) => {
        fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> ::core::cmp::Ordering {
            Self::orient2d_by_stage(a, b, c).0
        }

        fn in_circle(
            a: &[Self; 2],
            b: &[Self; 2],
            c: &[Self; 2],
            d: &[Self; 2],
        ) -> ::core::cmp::Ordering {
            Self::in_circle_by_stage(a, b, c, d).0
        }
    };
    (predicates: $other:ty, $convert:expr) => {
        $crate::scalar::forward::forward!(signs);

        fn orient2d_by_stage(
            a: &[Self; 2],
            b: &[Self; 2],
            c: &[Self; 2],
        ) -> (::core::cmp::Ordering, $crate::scalar::Stage) {
            let [a, b, c] = [a, b, c].map(|point| point.each_ref().map($convert));
            <$other as $crate::scalar::Scalar>::orient2d_by_stage(&a, &b, &c)
        }

        fn in_circle_by_stage(
            a: &[Self; 2],
            b: &[Self; 2],
            c: &[Self; 2],
            d: &[Self; 2],
        ) -> (::core::cmp::Ordering, $crate::scalar::Stage) {
            let [a, b, c, d] = [a, b, c, d].map(|point| point.each_ref().map($convert));
            <$other as $crate::scalar::Scalar>::in_circle_by_stage(&a, &b, &c, &d)
        }
    };
    (sizes: $other:ty, $convert:expr) => {
        fn depth(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Option<f64> {
            let [a, b, c, d] = [a, b, c, d].map(|point| point.each_ref().map($convert));
            <$other as $crate::scalar::Scalar>::depth(&a, &b, &c, &d)
        }

        fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
            let [a, b, c] = [a, b, c].map(|point| point.each_ref().map($convert));
            <$other as $crate::scalar::Scalar>::height(&a, &b, &c)
        }
    };
}

pub(super) use forward;
