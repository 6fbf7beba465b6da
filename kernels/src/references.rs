//! The sources of the equations, so that a citation in a kernel's documentation leads here.

macro_rules! references {
    ($($(#[$doc:meta])* $name:ident;)*) => {
        $(
            $(#[$doc])*
            #[derive(Debug)]
            pub enum $name {}
        )*
    };
}

references! {
    /// N. J. Higham, Accuracy and Stability of Numerical Algorithms, second edition, SIAM, 2002.
    Higham02;
    /// K. Iwasaki, Y. Dobashi, T. Nishita, Interactive Bi-scale Editing of Highly Glossy Materials,
    /// ACM Transactions on Graphics 31 (6), 2012.
    Iwasaki12;
    /// J. H. Lambert, Photometria sive de mensura et gradibus luminis, colorum et umbrae, 1760.
    Lambert1760;
    /// Rectangle-based Approximation for Rendering Glossy Interreflections.
    RectGlossy;
    /// Y. Tokuyoshi, Accurate Diffuse Lighting from Spherical Gaussian Lights, SIGGRAPH Posters, 2022, and its
    /// supplementary document.
    Tokuyoshi22;
    /// Y. Tokuyoshi, Virtual Spherical Gaussian Lights for Real-time Glossy Indirect Illumination, Computer
    /// Graphics Forum 34 (7), 2015.
    Tokuyoshi15;
    /// Y. Tokuyoshi, Fast Indirect Illumination Using Two Virtual Spherical Gaussian Lights, SIGGRAPH Asia
    /// Posters, 2015, and its supplemental material.
    Tokuyoshi15b;
    /// J. Wang, P. Ren, M. Gong, J. Snyder, B. Guo, All-Frequency Rendering of Dynamic, Spatially-Varying
    /// Reflectance, ACM Transactions on Graphics 28 (5), 2009.
    Wang09;
    /// K. Xu, W.-L. Sun, Z. Dong, D.-Y. Zhao, R.-D. Wu, S.-M. Hu, Anisotropic Spherical Gaussians, ACM
    /// Transactions on Graphics 32 (6), 2013.
    Xu13;
}
