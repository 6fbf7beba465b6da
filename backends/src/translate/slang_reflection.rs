//! What slang sees in a shader that it compiled: its entry points, resources, structures and functions.
#![allow(unsafe_code, reason = "slang is a C++ library that is loaded at run time")]

use std::ffi::{CStr, c_char, c_int, c_void};
use std::ptr;

use super::com::{Com, Status, blob_bytes};
use super::slang_api::{Request, symbol, text};

/// A shader as slang sees it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SlangReflection {
    /// The entry points.
    pub entries: Vec<SlangEntry>,
    /// The global resources, in order of their declaration.
    pub resources: Vec<SlangResource>,
    /// The structures that were asked for and are there.
    pub structures: Vec<SlangStructure>,
    /// The functions that were asked for and are there.
    pub functions: Vec<SlangFunction>,
}

/// An entry point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SlangEntry {
    /// Its name.
    pub name: String,
    /// Invocations in a workgroup.
    pub workgroup_size: [usize; 3],
}

/// A global resource.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SlangResource {
    /// Its name.
    pub name: String,
    /// HLSL's space.
    pub group: u32,
    /// HLSL's register.
    pub binding: u32,
}

/// A structure, as it lies in structured buffers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SlangStructure {
    /// Its name.
    pub name: String,
    /// Bytes, padding at the end included.
    pub size: usize,
    /// Its members.
    pub members: Vec<SlangMember>,
}

/// A member of a structure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SlangMember {
    /// Its name.
    pub name: String,
    /// Its type, as `vector<float,3>`.
    pub ty: String,
    /// Bytes from the structure's start.
    pub offset: usize,
}

/// A function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SlangFunction {
    /// Its name.
    pub name: String,
    /// Names and types of its parameters.
    pub parameters: Vec<(String, String)>,
    /// The type that it returns.
    pub returns: String,
}

type Object = *mut c_void;

/// `SLANG_PARAMETER_CATEGORY_UNIFORM`: sizes are in bytes.
const BYTES: c_int = 8;
/// `SLANG_LAYOUT_RULES_DEFAULT_STRUCTURED_BUFFER`.
const STRUCTURED_BUFFER: u32 = 2;

/// The functions of slang's reflection, once they were found.
#[rustfmt::skip]
#[derive(Clone, Copy)]
pub(super) struct Functions {
    of_request: unsafe extern "C" fn(Request) -> Object,
    entry_count: unsafe extern "C" fn(Object) -> usize,
    entry: unsafe extern "C" fn(Object, usize) -> Object,
    entry_name: unsafe extern "C" fn(Object) -> *const c_char,
    group_size: unsafe extern "C" fn(Object, usize, *mut usize),
    resource_count: unsafe extern "C" fn(Object) -> u32,
    resource: unsafe extern "C" fn(Object, u32) -> Object,
    resource_index: unsafe extern "C" fn(Object) -> u32,
    resource_space: unsafe extern "C" fn(Object) -> u32,
    find_type: unsafe extern "C" fn(Object, *const c_char) -> Object,
    type_layout: unsafe extern "C" fn(Object, Object, u32) -> Object,
    type_name: unsafe extern "C" fn(Object, *mut *mut c_void) -> Status,
    layout_size: unsafe extern "C" fn(Object, c_int) -> usize,
    field_count: unsafe extern "C" fn(Object) -> u32,
    field: unsafe extern "C" fn(Object, u32) -> Object,
    field_offset: unsafe extern "C" fn(Object, c_int) -> usize,
    variable_of: unsafe extern "C" fn(Object) -> Object,
    variable_name: unsafe extern "C" fn(Object) -> *const c_char,
    variable_type: unsafe extern "C" fn(Object) -> Object,
    find_function: unsafe extern "C" fn(Object, *const c_char) -> Object,
    parameter_count: unsafe extern "C" fn(Object) -> u32,
    parameter: unsafe extern "C" fn(Object, u32) -> Object,
    result_type: unsafe extern "C" fn(Object) -> Object,
}

impl Functions {
    #[rustfmt::skip]
    pub(super) fn find(library: &libloading::Library) -> Result<Self, String> {
        // SAFETY: each name is that of a function whose type in slang's header is the member's.
        unsafe {
            Ok(Self {
                of_request: symbol(library, c"spGetReflection")?,
                entry_count: symbol(library, c"spReflection_getEntryPointCount")?,
                entry: symbol(library, c"spReflection_getEntryPointByIndex")?,
                entry_name: symbol(library, c"spReflectionEntryPoint_getName")?,
                group_size: symbol(library, c"spReflectionEntryPoint_getComputeThreadGroupSize")?,
                resource_count: symbol(library, c"spReflection_GetParameterCount")?,
                resource: symbol(library, c"spReflection_GetParameterByIndex")?,
                resource_index: symbol(library, c"spReflectionParameter_GetBindingIndex")?,
                resource_space: symbol(library, c"spReflectionParameter_GetBindingSpace")?,
                find_type: symbol(library, c"spReflection_FindTypeByName")?,
                type_layout: symbol(library, c"spReflection_GetTypeLayout")?,
                type_name: symbol(library, c"spReflectionType_GetFullName")?,
                layout_size: symbol(library, c"spReflectionTypeLayout_GetSize")?,
                field_count: symbol(library, c"spReflectionTypeLayout_GetFieldCount")?,
                field: symbol(library, c"spReflectionTypeLayout_GetFieldByIndex")?,
                field_offset: symbol(library, c"spReflectionVariableLayout_GetOffset")?,
                variable_of: symbol(library, c"spReflectionVariableLayout_GetVariable")?,
                variable_name: symbol(library, c"spReflectionVariable_GetName")?,
                variable_type: symbol(library, c"spReflectionVariable_GetType")?,
                find_function: symbol(library, c"spReflection_FindFunctionByName")?,
                parameter_count: symbol(library, c"spReflectionFunction_GetParameterCount")?,
                parameter: symbol(library, c"spReflectionFunction_GetParameter")?,
                result_type: symbol(library, c"spReflectionFunction_GetResultType")?,
            })
        }
    }

    /// What slang says of a request, and of the structures and functions of these names.
    ///
    /// # Safety
    ///
    /// The request lives, and was compiled without errors.
    pub(super) unsafe fn read(&self, request: Request, names: &[&CStr]) -> Option<SlangReflection> {
        // SAFETY: the request was compiled.
        let program = unsafe { (self.of_request)(request) };
        if program.is_null() {
            return None;
        }
        // SAFETY: the program is the request's, and lives as long.
        unsafe {
            Some(SlangReflection {
                entries: (0..(self.entry_count)(program)).map(|i| self.entry(program, i)).collect(),
                resources: (0..(self.resource_count)(program)).map(|i| self.resource(program, i)).collect(),
                structures: names.iter().filter_map(|name| self.structure(program, name)).collect(),
                functions: names.iter().filter_map(|name| self.function(program, name)).collect(),
            })
        }
    }

    /// # Safety
    ///
    /// As for each below: the object is that of a request that lives, and an index is below its count.
    unsafe fn entry(&self, program: Object, index: usize) -> SlangEntry {
        let mut workgroup_size = [0; 3];
        // SAFETY: as the caller says; there is room for the three sizes that are asked for.
        unsafe {
            let entry = (self.entry)(program, index);
            (self.group_size)(entry, workgroup_size.len(), workgroup_size.as_mut_ptr());
            SlangEntry { name: text((self.entry_name)(entry)), workgroup_size }
        }
    }

    unsafe fn resource(&self, program: Object, index: u32) -> SlangResource {
        // SAFETY: as the caller says.
        unsafe {
            let resource = (self.resource)(program, index);
            SlangResource {
                name: text((self.variable_name)((self.variable_of)(resource))),
                group: (self.resource_space)(resource),
                binding: (self.resource_index)(resource),
            }
        }
    }

    unsafe fn structure(&self, program: Object, name: &CStr) -> Option<SlangStructure> {
        // SAFETY: as the caller says; what is not there is null.
        unsafe {
            let layout = match (self.find_type)(program, name.as_ptr()) {
                ty if ty.is_null() => ptr::null_mut(),
                ty => (self.type_layout)(program, ty, STRUCTURED_BUFFER),
            };
            (!layout.is_null()).then(|| SlangStructure {
                name: name.to_string_lossy().into_owned(),
                size: (self.layout_size)(layout, BYTES),
                members: (0..(self.field_count)(layout)).map(|i| self.member(layout, i)).collect(),
            })
        }
    }

    unsafe fn member(&self, layout: Object, index: u32) -> SlangMember {
        // SAFETY: as the caller says.
        unsafe {
            let field = (self.field)(layout, index);
            let (name, ty) = self.variable((self.variable_of)(field));
            SlangMember { name, ty, offset: (self.field_offset)(field, BYTES) }
        }
    }

    unsafe fn function(&self, program: Object, name: &CStr) -> Option<SlangFunction> {
        // SAFETY: as the caller says; what is not there is null.
        unsafe {
            let function = (self.find_function)(program, name.as_ptr());
            (!function.is_null()).then(|| SlangFunction {
                name: name.to_string_lossy().into_owned(),
                parameters: (0..(self.parameter_count)(function))
                    .map(|i| self.variable((self.parameter)(function, i)))
                    .collect(),
                returns: self.type_name((self.result_type)(function)),
            })
        }
    }

    /// Name and type of a variable.
    unsafe fn variable(&self, variable: Object) -> (String, String) {
        // SAFETY: as the caller says.
        unsafe {
            let name = text((self.variable_name)(variable));
            (name, self.type_name((self.variable_type)(variable)))
        }
    }

    unsafe fn type_name(&self, ty: Object) -> String {
        // SAFETY: as the caller says; the name comes in a blob.
        let name = Com::from_call(|blob| unsafe { (self.type_name)(ty, blob) });
        let bytes = name.map(|blob| blob_bytes(&blob)).unwrap_or_default();
        String::from_utf8_lossy(&bytes).trim_end_matches('\0').to_owned()
    }
}
