//! The few COM calls that DXC needs, with the library's own types.
//!
//! On Linux and macOS DXC brings a small COM of its own: the C calling convention, and 32-bit `wchar_t`.
#![allow(unsafe_code, reason = "DXC has a COM interface, called through function pointers in vtables")]

use std::ffi::c_void;
use std::ptr;

use super::com::{Com, Status, blob_bytes};

/// A class or interface identifier, as COM lays it out.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Guid(u32, u16, u16, [u8; 8]);

impl Guid {
    /// From the usual writing, `0x228b4687_5a6a_4730_900c_9702b2203f54`.
    const fn new(value: u128) -> Self {
        let rest = (value as u64).to_be_bytes();
        Self((value >> 96) as u32, (value >> 80) as u16, (value >> 64) as u16, rest)
    }
}

pub(super) const CLSID_COMPILER: Guid = Guid::new(0x73e22d93_e6ce_47f3_b5bf_f0664f39c1b0);
pub(super) const IID_COMPILER3: Guid = Guid::new(0x228b4687_5a6a_4730_900c_9702b2203f54);
pub(super) const IID_VERSION_INFO: Guid = Guid::new(0xb04f5b50_2059_4f12_a8ff_a1e0cde1cc7e);
const IID_RESULT: Guid = Guid::new(0x58346cda_dde7_4497_9461_6f87af5e0659);
const IID_BLOB: Guid = Guid::new(0x8ba5fb08_5195_40e2_ac58_0d989c3a0102);

/// The one function that the library exports for our use.
pub(super) type CreateInstance = unsafe extern "C" fn(*const Guid, *const Guid, *mut *mut c_void) -> Status;

/// `DxcBuffer`: bytes of ours.
#[repr(C)]
struct Source {
    bytes: *const c_void,
    size: usize,
    encoding: u32,
}

const UTF8: u32 = 65_001;
/// Of bytes that are no text (`DXC_CP_ACP`).
const BINARY: u32 = 0;

/// The outputs of a compilation that are asked for (`DXC_OUT_KIND`).
#[derive(Clone, Copy)]
pub(super) enum Output {
    Object = 1,
    Errors = 2,
    Disassembly = 5,
}

/// `IDxcCompiler3` or `IDxcVersionInfo`, made by the library.
pub(super) fn create(create: CreateInstance, interface: &Guid) -> Result<Com, Status> {
    // SAFETY: the function is DXC's `DxcCreateInstance`, and all three pointers are valid for the call.
    Com::from_call(|object| unsafe { create(&CLSID_COMPILER, interface, object) })
}

/// `IDxcVersionInfo::GetVersion`.
pub(super) fn version(info: &Com) -> Result<(u32, u32), Status> {
    let (mut major, mut minor) = (0, 0);
    // SAFETY: slot 3 of `IDxcVersionInfo`; both pointers are valid for the call.
    let status = unsafe {
        let get: unsafe extern "C" fn(*mut c_void, *mut u32, *mut u32) -> Status = info.function(3);
        get(info.this(), &mut major, &mut minor)
    };
    if status < 0 { Err(status) } else { Ok((major, minor)) }
}

type Compile = unsafe extern "C" fn(
    *mut c_void,
    *const Source,
    *const *const u32,
    u32,
    *mut c_void,
    *const Guid,
    *mut *mut c_void,
) -> Status;

/// `IDxcCompiler3::Compile`, without an include handler: an `#include` is an error that DXC reports.
pub(super) fn compile(compiler: &Com, hlsl: &str, arguments: &[String]) -> Result<Com, Status> {
    let source = Source { bytes: hlsl.as_ptr().cast(), size: hlsl.len(), encoding: UTF8 };
    let wide: Vec<Vec<u32>> = arguments.iter().map(|text| wide_string(text)).collect();
    let pointers: Vec<*const u32> = wide.iter().map(|text| text.as_ptr()).collect();
    let count = pointers.len() as u32;
    // SAFETY: slot 3 of `IDxcCompiler3`; source, arguments and identifier live until the call returns, and DXC keeps
    // none of them.
    Com::from_call(|result| unsafe {
        let compile: Compile = compiler.function(3);
        compile(compiler.this(), &source, pointers.as_ptr(), count, ptr::null_mut(), &IID_RESULT, result)
    })
}

type Disassemble = unsafe extern "C" fn(*mut c_void, *const Source, *const Guid, *mut *mut c_void) -> Status;

/// `IDxcCompiler3::Disassemble`.
pub(super) fn disassemble(compiler: &Com, dxil: &[u8]) -> Result<Com, Status> {
    let source = Source { bytes: dxil.as_ptr().cast(), size: dxil.len(), encoding: BINARY };
    // SAFETY: slot 4 of `IDxcCompiler3`; the bytes and the identifier live until the call returns.
    Com::from_call(|result| unsafe {
        let disassemble: Disassemble = compiler.function(4);
        disassemble(compiler.this(), &source, &IID_RESULT, result)
    })
}

fn wide_string(text: &str) -> Vec<u32> {
    text.chars().map(u32::from).chain([0]).collect()
}

/// `IDxcOperationResult::GetStatus`: whether the compilation itself went well.
pub(super) fn status(result: &Com) -> Result<Status, Status> {
    let mut verdict = 0;
    // SAFETY: slot 3 of `IDxcResult`; the pointer is valid for the call.
    let status = unsafe {
        let get: unsafe extern "C" fn(*mut c_void, *mut Status) -> Status = result.function(3);
        get(result.this(), &mut verdict)
    };
    if status < 0 { Err(status) } else { Ok(verdict) }
}

type GetOutput =
    unsafe extern "C" fn(*mut c_void, u32, *const Guid, *mut *mut c_void, *mut *mut c_void) -> Status;

/// `IDxcResult::GetOutput`, copied; empty if there is no such output.
pub(super) fn output(result: &Com, kind: Output) -> Vec<u8> {
    // SAFETY: slot 7 of `IDxcResult`; the name of the output is not asked for, which null says.
    let blob = Com::from_call(|blob| unsafe {
        let get: GetOutput = result.function(7);
        get(result.this(), kind as u32, &IID_BLOB, blob, ptr::null_mut())
    });
    blob.map(|blob| blob_bytes(&blob)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_are_laid_out_as_com_wants() {
        let Guid(a, b, c, rest) = IID_COMPILER3;
        assert_eq!((a, b, c), (0x228b_4687, 0x5a6a, 0x4730));
        assert_eq!(rest, [0x90, 0x0c, 0x97, 0x02, 0xb2, 0x20, 0x3f, 0x54]);
    }

    #[test]
    fn arguments_end_in_zero() {
        assert_eq!(wide_string("-T"), [45, 84, 0]);
    }
}
