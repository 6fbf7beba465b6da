//! References to COM objects, as DXC and slang hand them out on every system: the C calling convention, and vtables
//! that start with `QueryInterface`, `AddRef`, `Release`.
#![allow(unsafe_code, reason = "a COM interface is called through function pointers in vtables")]

use std::ffi::c_void;
use std::ptr::{self, NonNull};

/// `HRESULT`, which slang calls `SlangResult`; negative is failure.
pub(super) type Status = i32;

/// An owned reference to a COM object.
pub(super) struct Com(NonNull<c_void>);

impl Com {
    /// Takes over what a call returned through its last parameter.
    pub(super) fn from_call(call: impl FnOnce(*mut *mut c_void) -> Status) -> Result<Self, Status> {
        let mut object = ptr::null_mut();
        let status = call(&mut object);
        // A success without an object should not be; E_POINTER stands for it.
        NonNull::new(object).filter(|_| status >= 0).map(Self).ok_or(if status < 0 {
            status
        } else {
            0x8000_4003_u32 as i32
        })
    }

    /// The function in `slot` of the vtable.
    ///
    /// # Safety
    ///
    /// `F` must be the type of the function that the object's interface has there, its first parameter the object.
    pub(super) unsafe fn function<F: Copy>(&self, slot: usize) -> F {
        const { assert!(size_of::<F>() == size_of::<*const c_void>()) }
        // SAFETY: a COM object starts with a pointer to its vtable, an array of function pointers; the caller vouches
        // for the slot and its type.
        unsafe {
            let vtable: *const *const c_void = self.0.cast::<*const *const c_void>().read();
            vtable.add(slot).cast::<F>().read()
        }
    }

    pub(super) fn this(&self) -> *mut c_void {
        self.0.as_ptr()
    }
}

impl Drop for Com {
    fn drop(&mut self) {
        // SAFETY: `Release` is slot 2 of every COM object, and this reference is ours to give up.
        unsafe {
            let release: unsafe extern "C" fn(*mut c_void) -> u32 = self.function(2);
            release(self.this());
        }
    }
}

/// The bytes of a blob, `IDxcBlob` or `ISlangBlob`, copied.
pub(super) fn blob_bytes(blob: &Com) -> Vec<u8> {
    // SAFETY: slots 3 and 4 of either interface give pointer and size of bytes that live as long as the blob. The
    // pointer of an empty blob may be null, so no slice is made of it.
    unsafe {
        let pointer: unsafe extern "C" fn(*mut c_void) -> *const u8 = blob.function(3);
        let size: unsafe extern "C" fn(*mut c_void) -> usize = blob.function(4);
        let (pointer, size) = (pointer(blob.this()), size(blob.this()));
        if pointer.is_null() || size == 0 {
            Vec::new()
        } else {
            std::slice::from_raw_parts(pointer, size).to_vec()
        }
    }
}
