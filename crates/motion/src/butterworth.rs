//! Design of a digital Butterworth band-pass filter as second-order sections.
//!
//! Existing filter libraries take tan, sin and cos from the platform, so the last digits of filtered records would differ between machines.
//! Here these functions come from `libm`, and all other operations are + − × ÷ √.
//!
//! Source: A. V. Oppenheim and R. W. Schafer, *Discrete-Time Signal Processing*, on the bilinear transformation. The band is as in
//! `scipy.signal.butter(order, [low, high], "bandpass")`.

use std::f64::consts::PI;

/// A second-order section with zeros at z = ±1: H = g (1 − z⁻²) / (1 + a₁z⁻¹ + a₂z⁻²).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Section {
    gain: f64,
    a1: f64,
    a2: f64,
    /// The two delays of the transposed second form.
    memory: [f64; 2],
}

impl Section {
    /// A section from s²-coefficients: width·s / (s² − sum·s + product), in the variable s = (z − 1)/(z + 1).
    fn new(width: f64, sum: f64, product: f64) -> Self {
        // sum < 0 <= product, hence the denominator is above 1.
        let scale = 1.0 / (1.0 - sum + product);
        Self {
            gain: width * scale,
            a1: 2.0 * (product - 1.0) * scale,
            a2: (1.0 + sum + product) * scale,
            memory: [0.0; 2],
        }
    }

    /// Filters the next sample.
    fn next(&mut self, input: f64) -> f64 {
        let output = self.gain * input + self.memory[0];
        self.memory[0] = self.memory[1] - self.a1 * output;
        self.memory[1] = -self.gain * input - self.a2 * output;
        output
    }

    /// Sets the steady state of a constant input, whose output is zero.
    fn settle(&mut self, input: f64) {
        self.memory = [-self.gain * input; 2];
    }
}

/// A band-pass filter with its memory, at rest to begin with.
#[derive(Debug, Clone)]
pub(crate) struct Cascade {
    sections: Vec<Section>,
}

impl Cascade {
    /// A filter of an order ≥ 1 with corners 0 < low < high < 1/2 in cycles per sample.
    pub(crate) fn band_pass(order: u32, low: f64, high: f64) -> Self {
        // The bilinear transformation bends frequencies; the corners are bent the other way beforehand.
        let [low, high] = [low, high].map(|corner| libm::tan(PI * corner));
        let (width, centre) = (high - low, low * high);
        let mut sections = Vec::new();
        for index in 0..order / 2 {
            let angle = PI * f64::from(2 * index + 1) / f64::from(2 * order);
            // A pole p of the low-pass filter becomes two, the roots of s² − width·p·s + centre.
            let half = [-0.5 * width * libm::sin(angle), 0.5 * width * libm::cos(angle)];
            let outer = outer_root(half, centre);
            let size = outer[0] * outer[0] + outer[1] * outer[1];
            sections.push(Section::new(width, 2.0 * outer[0], size));
            // The product of the two roots is `centre`, so no difference of large numbers is needed, however wide the band.
            let inner = centre / size;
            sections.push(Section::new(width, 2.0 * inner * outer[0], inner * centre));
        }
        if order % 2 == 1 {
            // The pole −1 of the low-pass filter.
            sections.push(Section::new(width, -width, centre));
        }
        Self { sections }
    }

    /// Filters the next sample.
    pub(crate) fn next(&mut self, input: f64) -> f64 {
        let through = |input, section: &mut Section| section.next(input);
        self.sections.iter_mut().fold(input, through)
    }

    /// Sets the steady state of a constant input.
    pub(crate) fn settle(&mut self, input: f64) {
        let mut input = input;
        for section in &mut self.sections {
            section.settle(input);
            input = 0.0;
        }
    }
}

/// The root of s² − 2·half·s + centre that is farther from zero; `half` is complex, `centre` real.
fn outer_root([re, im]: [f64; 2], centre: f64) -> [f64; 2] {
    let [square_re, square_im] = [re * re - im * im - centre, 2.0 * re * im];
    let size = (square_re * square_re + square_im * square_im).sqrt();
    // The larger part of the square root comes first, and the other from the product: neither loses digits.
    let large = (0.5 * (size + square_re.abs())).sqrt();
    // Both vanish together if the two roots coincide.
    let small = if large > 0.0 { 0.5 * square_im / large } else { 0.0 };
    let [root_re, root_im] = if square_re >= 0.0 { [large, small] } else { [small, large] };
    let sign = if re * root_re + im * root_im >= 0.0 { 1.0 } else { -1.0 };
    [re + sign * root_re, im + sign * root_im]
}
