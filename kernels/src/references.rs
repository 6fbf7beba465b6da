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
    /// M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions, National Bureau of Standards, 1964.
    Abramowitz64;
    /// T. F. Chan, G. H. Golub, R. J. LeVeque, Algorithms for Computing the Sample Variance: Analysis and
    /// Recommendations, The American Statistician 37 (3), 1983.
    Chan83;
    /// R. L. Cook, K. E. Torrance, A Reflectance Model for Computer Graphics, ACM Transactions on Graphics
    /// 1 (1), 1982.
    CookTorrance82;
    /// C. Dachsbacher, M. Stamminger, Reflective Shadow Maps, Interactive 3D Graphics and Games, 2005.
    DachsbacherStamminger05;
    /// T. Duff, J. Burgess, P. Christensen, C. Hery, A. Kensler, M. Liani, R. Villemin, Building an Orthonormal
    /// Basis, Revisited, Journal of Computer Graphics Techniques 6 (1), 2017.
    Duff17;
    /// J. Dupuy, A. Benyoub, Sampling Visible GGX Normals with Spherical Caps, Computer Graphics Forum 42 (8),
    /// 2023.
    Dupuy23;
    /// M. Hašan, J. Křivánek, B. Walter, K. Bala, Virtual Spherical Lights for Many-Light Rendering of Glossy
    /// Scenes, ACM Transactions on Graphics 28 (5), 2009.
    Hasan09;
    /// W. Heidrich, H.-P. Seidel, View-Independent Environment Maps, Workshop on Graphics Hardware, 1998.
    HeidrichSeidel98;
    /// E. Heitz, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs, Journal of Computer
    /// Graphics Techniques 3 (2), 2014.
    Heitz14;
    /// E. Heitz, Sampling the GGX Distribution of Visible Normals, Journal of Computer Graphics Techniques 7 (4),
    /// 2018.
    Heitz18;
    /// N. J. Higham, Accuracy and Stability of Numerical Algorithms, second edition, SIAM, 2002.
    Higham02;
    /// D. Hilbert, Ueber die stetige Abbildung einer Linie auf ein Flächenstück, Mathematische Annalen 38, 1891.
    Hilbert1891;
    /// W. D. Hillis, G. L. Steele, Data Parallel Algorithms, Communications of the ACM 29 (12), 1986.
    HillisSteele86;
    /// T. Ize, Robust BVH Ray Traversal, Journal of Computer Graphics Techniques 2 (2), 2013.
    Ize13;
    /// K. Iwasaki, Y. Dobashi, T. Nishita, Interactive Bi-scale Editing of Highly Glossy Materials,
    /// ACM Transactions on Graphics 31 (6), 2012.
    Iwasaki12;
    /// M. Jarzynski, M. Olano, Hash Functions for GPU Rendering, Journal of Computer Graphics Techniques 9 (3), 2020.
    Jarzynski20;
    /// A. Keller, Instant Radiosity, SIGGRAPH, 1997.
    Keller97;
    /// J. Křivánek, M. Colbert, Real-time Shading with Filtered Importance Sampling, Computer Graphics Forum
    /// 27 (4), 2008.
    KrivanekColbert08;
    /// J. H. Lambert, Photometria sive de mensura et gradibus luminis, colorum et umbrae, 1760.
    Lambert1760;
    /// This library: derivations of its own, written down in the documentation of the module that is named.
    Lobe;
    /// M. E. O'Neill, PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for Random Number
    /// Generation, Technical Report HMC-CS-2014-0905, Harvey Mudd College, 2014.
    ONeill14;
    /// M. Pharr, W. Jakob, G. Humphreys, Physically Based Rendering, fourth edition, MIT Press, 2023.
    Pharr23;
    /// Rectangle-based Approximation for Rendering Glossy Interreflections.
    RectGlossy;
    /// T. Ritschel, T. Grosch, M. H. Kim, H.-P. Seidel, C. Dachsbacher, J. Kautz, Imperfect Shadow Maps for Efficient
    /// Computation of Indirect Illumination, ACM Transactions on Graphics 27 (5), 2008.
    Ritschel08;
    /// T. Ritschel, E. Eisemann, I. Ha, J. D. K. Kim, H.-P. Seidel, Making Imperfect Shadow Maps View-Adaptive:
    /// High-Quality Global Illumination in Large Dynamic Scenes, Computer Graphics Forum 30 (8), 2011.
    Ritschel11;
    /// M. Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018.
    Roberts18;
    /// P. Shirley, K. Chiu, A Low Distortion Map Between Disk and Square, Journal of Graphics Tools 2 (3), 1997.
    ShirleyChiu97;
    /// C. Schlick, An Inexpensive BRDF Model for Physically-Based Rendering, Computer Graphics Forum 13 (3), 1994.
    Schlick94;
    /// M. Toksvig, Mipmapping Normal Maps, Journal of Graphics Tools 10 (3), 2005.
    Toksvig05;
    /// Y. Tokuyoshi, Virtual Spherical Gaussian Lights for Real-time Glossy Indirect Illumination, Computer
    /// Graphics Forum 34 (7), 2015.
    Tokuyoshi15;
    /// Y. Tokuyoshi, Fast Indirect Illumination Using Two Virtual Spherical Gaussian Lights, SIGGRAPH Asia
    /// Posters, 2015, and its supplemental material.
    Tokuyoshi15b;
    /// Y. Tokuyoshi, Accurate Diffuse Lighting from Spherical Gaussian Lights, SIGGRAPH Posters, 2022, and its
    /// supplementary document.
    Tokuyoshi22;
    /// E. Veach, Robust Monte Carlo Methods for Light Transport Simulation, PhD thesis, Stanford University, 1997.
    Veach97;
    /// M. D. Vose, A Linear Algorithm for Generating Random Numbers with a Given Distribution, IEEE Transactions on
    /// Software Engineering 17 (9), 1991.
    Vose91;
    /// B. Walter, S. R. Marschner, H. Li, K. E. Torrance, Microfacet Models for Refraction through Rough Surfaces,
    /// Eurographics Symposium on Rendering, 2007.
    Walter07;
    /// J. Wang, P. Ren, M. Gong, J. Snyder, B. Guo, All-Frequency Rendering of Dynamic, Spatially-Varying
    /// Reflectance, ACM Transactions on Graphics 28 (5), 2009.
    Wang09;
    /// B. P. Welford, Note on a Method for Calculating Corrected Sums of Squares and Products, Technometrics 4 (3),
    /// 1962.
    Welford62;
    /// S. Woop, C. Benthin, I. Wald, Watertight Ray/Triangle Intersection, Journal of Computer Graphics Techniques
    /// 2 (1), 2013.
    Woop13;
    /// K. Xu, W.-L. Sun, Z. Dong, D.-Y. Zhao, R.-D. Wu, S.-M. Hu, Anisotropic Spherical Gaussians, ACM
    /// Transactions on Graphics 32 (6), 2013.
    Xu13;
    /// K. Xu, Y.-P. Cao, L.-Q. Ma, Z. Dong, R. Wang, S.-M. Hu, A Practical Algorithm for Rendering Interreflections
    /// with All-frequency BRDFs, ACM Transactions on Graphics 33 (1), 2014.
    Xu14;
}
