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
    /// T. F. Chan, G. H. Golub, R. J. LeVeque, Algorithms for Computing the Sample Variance: Analysis and
    /// Recommendations, The American Statistician 37 (3), 1983.
    Chan83;
    /// M. Hašan, J. Křivánek, B. Walter, K. Bala, Virtual Spherical Lights for Many-Light Rendering of Glossy
    /// Scenes, ACM Transactions on Graphics 28 (5), 2009.
    Hasan09;
    /// N. J. Higham, Accuracy and Stability of Numerical Algorithms, second edition, SIAM, 2002.
    Higham02;
    /// K. Iwasaki, Y. Dobashi, T. Nishita, Interactive Bi-scale Editing of Highly Glossy Materials,
    /// ACM Transactions on Graphics 31 (6), 2012.
    Iwasaki12;
    /// A. Keller, Instant Radiosity, SIGGRAPH, 1997.
    Keller97;
    /// J. Křivánek, M. Colbert, Real-time Shading with Filtered Importance Sampling, Computer Graphics Forum
    /// 27 (4), 2008.
    KrivanekColbert08;
    /// Rectangle-based Approximation for Rendering Glossy Interreflections.
    RectGlossy;
    /// T. Ritschel, E. Eisemann, I. Ha, J. D. K. Kim, H.-P. Seidel, Making Imperfect Shadow Maps View-Adaptive:
    /// High-Quality Global Illumination in Large Dynamic Scenes, Computer Graphics Forum 30 (8), 2011.
    Ritschel11;
    /// M. Toksvig, Mipmapping Normal Maps, Journal of Graphics Tools 10 (3), 2005.
    Toksvig05;
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
    /// K. Xu, Y.-P. Cao, L.-Q. Ma, Z. Dong, R. Wang, S.-M. Hu, A Practical Algorithm for Rendering Interreflections
    /// with All-frequency BRDFs, ACM Transactions on Graphics 33 (1), 2014.
    Xu14;
}
