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
    /// This library: derivations of its own, written down in the documentation of the module that is named.
    Lobe;
    /// Y. Tokuyoshi, Accurate Diffuse Lighting from Spherical Gaussian Lights, SIGGRAPH Posters, 2022, and its
    /// supplementary document.
    Tokuyoshi22;
    /// J. Wang, P. Ren, M. Gong, J. Snyder, B. Guo, All-Frequency Rendering of Dynamic, Spatially-Varying
    /// Reflectance, ACM Transactions on Graphics 28 (5), 2009.
    Wang09;
}
