//! Numbers as people read them: thousands apart, as many digits as matter, a dash for what was not measured.

/// Stands for a value that was not measured.
pub const MISSING: &str = "–";

/// An integer with a thin gap every three digits: `1 234 567`.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// Parts per million: whole above 10, one decimal below.
pub fn ppm(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        v if v < 10.0 => format!("{v:.1}"),
        v => grouped(v.round() as u64),
    }
}

/// Milliseconds with three digits or so, or a dash.
pub fn ms(value: Option<f64>) -> String {
    value.map_or(MISSING.to_owned(), |v| match v {
        v if v < 1.0 => format!("{v:.3}"),
        v if v < 100.0 => format!("{v:.2}"),
        v => format!("{v:.1}"),
    })
}

/// A value with that many decimals, or a dash for missing or NaN.
pub fn decimals(value: Option<f64>, digits: usize) -> String {
    value.filter(|v| !v.is_nan()).map_or(MISSING.to_owned(), |v| format!("{v:.digits$}"))
}

/// A factor, `3.2×`, or a dash.
pub fn factor(value: Option<f64>) -> String {
    value.map_or(MISSING.to_owned(), |v| if v < 100.0 { format!("{v:.2}×") } else { format!("{v:.0}×") })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_stand_apart() {
        assert_eq!([0, 7, 999, 1000, 1_234_567].map(grouped), ["0", "7", "999", "1 000", "1 234 567"]);
    }

    #[test]
    fn small_rates_do_not_look_like_none() {
        assert_eq!([0.0, 1.08, 12.4, 12_345.6].map(ppm), ["0", "1.1", "12", "12 346"]);
    }

    #[test]
    fn missing_is_a_dash_and_never_zero() {
        assert_eq!(ms(None), "–");
        assert_eq!(decimals(Some(f64::NAN), 3), "–");
        assert_eq!(factor(None), "–");
        assert_eq!([ms(Some(0.0)), ms(Some(1.234)), ms(Some(123.4))], ["0.000", "1.23", "123.4"]);
        assert_eq!([factor(Some(2.0)), factor(Some(512.0))], ["2.00×", "512×"]);
    }
}
