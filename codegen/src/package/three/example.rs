//! A page with a sphere that shines as a kernel says.

use super::super::Contents;
use super::super::example::{self, Example};
use super::items::in_tsl;
use crate::emit::reflect::FunctionInfo;
use std::collections::BTreeSet;

/// The type of an argument that the sphere's normal may be.
const DIRECTION: &str = "vec3<f32>";

pub(super) fn page(contents: &Contents<'_>) -> Option<String> {
    let has_direction = |f: &FunctionInfo| f.parameters.iter().any(|p| p.ty == DIRECTION);
    let example = example::such_that(contents, has_direction).or_else(|| example::of(contents))?;
    let mut nodes = Nodes::new(&example, contents.prefix);
    let result = nodes.result();
    let list = |names: &BTreeSet<String>| names.iter().map(String::as_str).collect::<Vec<_>>().join(", ");
    let (tsl, lobe) = (list(&nodes.tsl), list(&nodes.lobe));
    Some(format!(
        "{HEAD}import {{ {tsl} }} from 'three/tsl';\nimport {{ {lobe} }} from './lobe.js';\n\nconst brightness = \
         uniform(0.5);\nconst material = new THREE.MeshBasicNodeMaterial();\nmaterial.colorNode = \
         vec3({result}).mul(brightness);\n{REST}"
    ))
}

/// Writes nodes, and keeps what they import.
struct Nodes<'a> {
    example: &'a Example,
    prefix: &'a str,
    tsl: BTreeSet<String>,
    lobe: BTreeSet<String>,
}

impl<'a> Nodes<'a> {
    fn new(example: &'a Example, prefix: &'a str) -> Self {
        Self {
            example,
            prefix,
            tsl: BTreeSet::from(["uniform", "vec3"].map(str::to_owned)),
            lobe: BTreeSet::new(),
        }
    }

    /// The first number of what the kernel returns for the sphere's normal.
    fn result(&mut self) -> String {
        let function = &self.example.function;
        let along_normal = function.parameters.iter().position(|p| p.ty == DIRECTION);
        let mut arguments = Vec::new();
        for (i, parameter) in function.parameters.iter().enumerate() {
            let value =
                if along_normal == Some(i) { self.tsl("normalWorld") } else { self.value(&parameter.ty) };
            arguments.push(format!("{}: {value}", parameter.name));
        }
        let name = self.lobe(&function.name);
        let first = self.first(function.returns.as_deref().unwrap_or_default());
        format!("{name}({{ {} }}){first}", arguments.join(", "))
    }

    /// A value of a type.
    fn value(&mut self, ty: &str) -> String {
        if let Some(members) = self.example.members(ty) {
            let members: Vec<String> =
                members.iter().map(|m| format!("{}: {}", m.name, self.value(&m.ty))).collect();
            return format!("{}({{ {} }})", self.lobe(ty), members.join(", "));
        }
        let node = self.tsl(in_tsl(ty));
        let numbers = match node.as_str() {
            "float" => "0.5",
            "vec2" => "0.6, 0.8",
            "vec3" => "0, 0.6, 0.8",
            "vec4" => "0.1, 0.2, 0.3, 0.4",
            _ => "1",
        };
        format!("{node}({numbers})")
    }

    /// How a float is made of a value: its first component or member.
    fn first(&self, ty: &str) -> String {
        match self.example.members(ty).and_then(<[_]>::first) {
            Some(member) => format!(".get('{}'){}", member.name, self.first(&member.ty)),
            None if ty.starts_with("vec") => ".x".to_owned(),
            None => String::new(),
        }
    }

    fn tsl(&mut self, name: &str) -> String {
        self.tsl.insert(name.to_owned());
        name.to_owned()
    }

    fn lobe(&mut self, name: &str) -> String {
        let name = name.strip_prefix(self.prefix).unwrap_or(name).to_owned();
        self.lobe.insert(name.clone());
        name
    }
}

const HEAD: &str = r#"<!DOCTYPE html>
<meta charset="utf-8">
<title>A kernel of Lobe in three.js</title>
<body style="margin: 0">
<script type="importmap">{ "imports": {
    "three/webgpu": "./node_modules/three/build/three.webgpu.js",
    "three/tsl": "./node_modules/three/build/three.tsl.js"
} }</script>
<script type="module">
import * as THREE from 'three/webgpu';
"#;

const REST: &str = "\
const scene = new THREE.Scene().add(new THREE.Mesh(new THREE.SphereGeometry(1, 64, 32), material));
const camera = new THREE.PerspectiveCamera(40, innerWidth / innerHeight, 0.1, 10);
camera.position.z = 4;

const renderer = new THREE.WebGPURenderer({ antialias: true });
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);
renderer.setAnimationLoop(() => renderer.render(scene, camera));
</script>
";
