//! The functions of slang's library that Lobe calls, with the library's own types.
//!
//! This is the C interface, of which releases keep names and order of parameters; of its COM interface only a blob is
//! needed, the object that code is handed over in.
#![allow(unsafe_code, reason = "slang is a C++ library that is loaded at run time")]

use std::ffi::{CStr, c_char, c_int, c_void};
use std::path::Path;
use std::ptr::{self, NonNull};

use super::com::{Com, Status, blob_bytes};
use super::elf;
use super::slang_reflection::{Functions, SlangReflection};

/// `SLANG_SOURCE_LANGUAGE_HLSL`.
const HLSL: c_int = 2;
/// `SLANG_STAGE_COMPUTE`.
const COMPUTE: u32 = 6;
/// The first target of a request, and its only one.
const TARGET: c_int = 0;

type Session = *mut c_void;
pub(super) type Request = *mut c_void;

/// The functions, once they were found.
#[derive(Clone, Copy)]
pub(super) struct Api {
    build_tag: unsafe extern "C" fn() -> *const c_char,
    create_session: unsafe extern "C" fn(*const c_char) -> Session,
    destroy_session: unsafe extern "C" fn(Session),
    create_request: unsafe extern "C" fn(Session) -> Request,
    destroy_request: unsafe extern "C" fn(Request),
    take_arguments: unsafe extern "C" fn(Request, *const *const c_char, c_int) -> Status,
    add_unit: unsafe extern "C" fn(Request, c_int, *const c_char) -> c_int,
    add_source: unsafe extern "C" fn(Request, c_int, *const c_char, *const c_char, *const c_char),
    add_entry: unsafe extern "C" fn(Request, c_int, *const c_char, u32) -> c_int,
    compile: unsafe extern "C" fn(Request) -> Status,
    messages: unsafe extern "C" fn(Request) -> *const c_char,
    target_code: unsafe extern "C" fn(Request, c_int, *mut *mut c_void) -> Status,
    /// `None` in releases without.
    reflection: Option<Functions>,
}

impl Api {
    /// Loads the library at `path` for as long as the process lives.
    pub(super) fn load(path: &Path) -> Result<Self, String> {
        elf::check_complete(path)?;
        // SAFETY: loading runs the library's initialisers; the user or setup chose this file as slang.
        let library = unsafe { libloading::Library::new(path) }.map_err(|error| elf::explain(&error))?;
        let found = Self::find(&library)?;
        // The function pointers outlive this function.
        std::mem::forget(library);
        Ok(found)
    }

    fn find(library: &libloading::Library) -> Result<Self, String> {
        // SAFETY: each name is that of a function whose type in slang's header is the member's.
        unsafe {
            Ok(Self {
                build_tag: symbol(library, c"spGetBuildTagString")?,
                create_session: symbol(library, c"spCreateSession")?,
                destroy_session: symbol(library, c"spDestroySession")?,
                create_request: symbol(library, c"spCreateCompileRequest")?,
                destroy_request: symbol(library, c"spDestroyCompileRequest")?,
                take_arguments: symbol(library, c"spProcessCommandLineArguments")?,
                add_unit: symbol(library, c"spAddTranslationUnit")?,
                add_source: symbol(library, c"spAddTranslationUnitSourceStringSpan")?,
                add_entry: symbol(library, c"spAddEntryPoint")?,
                compile: symbol(library, c"spCompile")?,
                messages: symbol(library, c"spGetDiagnosticOutput")?,
                target_code: symbol(library, c"spGetTargetCodeBlob")?,
                reflection: Functions::find(library).ok(),
            })
        }
    }

    /// What the library calls its release.
    pub(super) fn version(&self) -> String {
        // SAFETY: the function takes nothing and returns a string that the library keeps.
        unsafe { text((self.build_tag)()) }
    }
}

/// # Safety
///
/// `F` must be the type of the function of that name.
pub(super) unsafe fn symbol<F: Copy>(library: &libloading::Library, name: &CStr) -> Result<F, String> {
    // SAFETY: the caller vouches for the type.
    let found = unsafe { library.get::<F>(name.to_bytes_with_nul()) };
    found.map(|symbol| *symbol).map_err(|error| format!("it is not slang: {}", elf::explain(&error)))
}

/// # Safety
///
/// The pointer is null or that of a string that ends in zero.
pub(super) unsafe fn text(pointer: *const c_char) -> String {
    if pointer.is_null() {
        return String::new();
    }
    // SAFETY: as the caller says.
    unsafe { CStr::from_ptr(pointer) }.to_string_lossy().into_owned()
}

/// A session: slang's core library, unpacked. It serves one thread at a time, which `&mut` sees to.
pub(super) struct OpenSession {
    api: Api,
    session: NonNull<c_void>,
}

// SAFETY: a session keeps nothing that belongs to the thread that made it.
unsafe impl Send for OpenSession {}

/// What came of a compilation.
pub(super) struct Outcome<T> {
    /// The code, or what else was asked for; `None` if there is none.
    pub(super) found: Option<T>,
    /// Errors and warnings.
    pub(super) messages: String,
}

impl OpenSession {
    pub(super) fn new(api: Api) -> Option<Self> {
        // SAFETY: the parameter is one that slang no longer reads.
        let session = NonNull::new(unsafe { (api.create_session)(ptr::null()) })?;
        Some(Self { api, session })
    }

    /// Compiles `hlsl`, whose entry point is `entry`, as `arguments` of the command line say.
    pub(super) fn compile(&mut self, arguments: &[&CStr], hlsl: &str, entry: &CStr) -> Outcome<Vec<u8>> {
        self.compiled(arguments, hlsl, entry, OpenRequest::code)
    }

    /// Compiles `hlsl` likewise, and says what is in it, of structures and functions those of `names`.
    pub(super) fn reflect(
        &mut self,
        arguments: &[&CStr],
        hlsl: &str,
        entry: &CStr,
        names: &[&CStr],
    ) -> Outcome<SlangReflection> {
        self.compiled(arguments, hlsl, entry, |request| request.reflection(names))
    }

    /// Compiles `hlsl`, and takes what is wanted of the request if that went well.
    fn compiled<T>(
        &mut self,
        arguments: &[&CStr],
        hlsl: &str,
        entry: &CStr,
        take: impl FnOnce(&OpenRequest) -> Option<T>,
    ) -> Outcome<T> {
        // SAFETY: the session lives as long as `self`.
        let request = unsafe { (self.api.create_request)(self.session.as_ptr()) };
        if request.is_null() {
            return Outcome { found: None, messages: "it takes no request".to_owned() };
        }
        let request = OpenRequest { api: self.api, request };
        let found = if request.compile(arguments, hlsl, entry) { take(&request) } else { None };
        // SAFETY: the request lives, and so does the string.
        let messages = unsafe { text((self.api.messages)(request.request)) };
        Outcome { found, messages }
    }
}

impl Drop for OpenSession {
    fn drop(&mut self) {
        // SAFETY: the session is ours, and its requests are gone.
        unsafe { (self.api.destroy_session)(self.session.as_ptr()) }
    }
}

struct OpenRequest {
    api: Api,
    request: Request,
}

impl OpenRequest {
    /// Whether it went well.
    fn compile(&self, arguments: &[&CStr], hlsl: &str, entry: &CStr) -> bool {
        let Self { api, request } = self;
        let pointers: Vec<*const c_char> = arguments.iter().map(|argument| argument.as_ptr()).collect();
        let text = hlsl.as_bytes().as_ptr_range();
        // SAFETY: the request lives, every string ends in zero or is given with its end, and slang copies them.
        unsafe {
            if (api.take_arguments)(*request, pointers.as_ptr(), pointers.len() as c_int) < 0 {
                return false;
            }
            let unit = (api.add_unit)(*request, HLSL, c"shader".as_ptr());
            (api.add_source)(*request, unit, c"shader.hlsl".as_ptr(), text.start.cast(), text.end.cast());
            (api.add_entry)(*request, unit, entry.as_ptr(), COMPUTE) >= 0 && (api.compile)(*request) >= 0
        }
    }

    /// The code, once it was compiled, if there is any.
    ///
    /// It is asked for as that of the target: SPIR-V is written for a module as a whole, and the library crashes when
    /// it is asked for the code of an entry point.
    fn code(&self) -> Option<Vec<u8>> {
        // SAFETY: the request was compiled, which is what the call asks for.
        let blob = Com::from_call(|blob| unsafe { (self.api.target_code)(self.request, TARGET, blob) });
        blob.ok().map(|blob| blob_bytes(&blob))
    }

    /// What is in it, once it was compiled.
    fn reflection(&self, names: &[&CStr]) -> Option<SlangReflection> {
        // SAFETY: the request lives and was compiled.
        self.api.reflection.and_then(|functions| unsafe { functions.read(self.request, names) })
    }
}

impl Drop for OpenRequest {
    fn drop(&mut self) {
        // SAFETY: the request is ours to give up.
        unsafe { (self.api.destroy_request)(self.request) }
    }
}
