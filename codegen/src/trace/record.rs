//! A kernel that writes down what it computes.

use super::pen::{self, Pen};
use super::rewrite::{Known, Probe, rewrite};
use super::{Site, TraceError};
use crate::ValidModule;
use crate::emit::{EntryLayout, with_entry};
use crate::validate::validate;
use naga::{
    AddressSpace, ArraySize, BinaryOperator, Expression, Function, Handle, Module, Scalar, ScalarKind,
    Statement, StorageAccess, StructMember, TypeInner,
};

/// Bytes of a record: site, bits, number.
const STRIDE: u32 = 12;

/// A kernel's module with traces, and an entry point for one row.
#[derive(Debug, Clone)]
pub struct Traced {
    /// The module; only its entry point is of use.
    pub module: ValidModule,
    /// What the entry point reads and writes.
    pub layout: EntryLayout,
    /// Binding in group 0 of the buffer of records.
    pub binding: u32,
    /// Records that the buffer holds; later ones are lost.
    pub capacity: u32,
    /// The sites, by number.
    pub sites: Vec<Site>,
}

/// A scalar, as it was computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Record {
    /// Index of its site.
    pub site: u32,
    /// The number's bits; 0 or 1 of a boolean.
    pub bits: u32,
}

impl Traced {
    /// Bytes of the buffer of records.
    #[must_use]
    pub fn bytes(&self) -> usize {
        (self.capacity * STRIDE) as usize
    }

    /// The records in such a buffer, in the order of execution; all of them, if there are fewer than
    /// [`Traced::capacity`].
    #[must_use]
    pub fn records(&self, bytes: &[u8]) -> Vec<Record> {
        let word = |bytes: &[u8]| bytes.try_into().map_or(0, u32::from_le_bytes);
        let records =
            bytes.chunks_exact(STRIDE as usize).map(|r| (word(&r[..4]), word(&r[4..8]), word(&r[8..])));
        // Sites are written from 1, so that a buffer of zeros holds none.
        let written = records.take_while(|(site, ..)| *site != 0);
        written
            .map(|(site, bits, number)| {
                let site = site - 1;
                let is_float = self.sites.get(site as usize).is_some_and(|s| s.kind == ScalarKind::Float);
                Record { site, bits: if is_float { number } else { bits } }
            })
            .collect()
    }
}

/// The kernel `function` of `module`, such that it writes down up to `capacity` scalars.
///
/// # Errors
/// When it uses something that kernels do not, or takes or returns something that no buffer holds.
pub fn record(module: &ValidModule, function: Handle<Function>, capacity: u32) -> Result<Traced, TraceError> {
    let mut built = Module { functions: Default::default(), doc_comments: None, ..module.module().clone() };
    let binding = module.module().functions[function].arguments.len() as u32 + 2;
    let recorder = recorder(&mut built, binding, capacity);
    let rewritten = rewrite(module, built, &Recorder(recorder))?;
    let valid = validate(rewritten.module, rewritten.meta)?;
    let (module, layout) = with_entry(&valid, rewritten.functions[&function], 1)?;
    Ok(Traced { module, layout, binding, capacity, sites: rewritten.sites })
}

/// `fn trace_record(site, bits, number)`, which appends to the buffer.
fn recorder(module: &mut Module, binding: u32, capacity: u32) -> Handle<Function> {
    let u32 = pen::scalar_type(module, Scalar::U32);
    let f32 = pen::scalar_type(module, Scalar::F32);
    let member =
        |name: &str, ty, offset| StructMember { name: Some(name.to_owned()), ty, binding: None, offset };
    let members = vec![member("site", u32, 0), member("bits", u32, 4), member("number", f32, 8)];
    let record = naga::Type {
        name: Some("TraceRecord".to_owned()),
        inner: TypeInner::Struct { members, span: STRIDE },
    };
    let record = module.types.insert(record, naga::Span::UNDEFINED);
    let array = TypeInner::Array { base: record, size: ArraySize::Dynamic, stride: STRIDE };
    let array = pen::type_of(module, array);
    let access = StorageAccess::LOAD | StorageAccess::STORE;
    let at = Some(naga::ResourceBinding { group: 0, binding });
    let records = pen::variable(module, "trace_records", AddressSpace::Storage { access }, at, array);
    let count = pen::variable(module, "trace_count", AddressSpace::Private, None, u32);

    let mut function = Function { name: Some("trace_record".to_owned()), ..Function::default() };
    function.arguments =
        [("site", u32), ("bits", u32), ("number", f32)].map(|(name, ty)| pen::parameter(name, ty)).to_vec();
    let mut pen = Pen::new(&mut function);
    let arguments = [0, 1, 2].map(|i| pen.declare(Expression::FunctionArgument(i)));
    let records = pen.declare(Expression::GlobalVariable(records));
    let count = pen.declare(Expression::GlobalVariable(count));
    let (capacity, one) = (pen.literal(capacity), pen.literal(1));
    let now = pen.load(count);
    let has_room = pen.binary(BinaryOperator::Less, now, capacity);
    pen.when(has_room, |pen| {
        let record = pen.compute(Expression::Access { base: records, index: now });
        for (index, value) in (0..).zip(arguments) {
            let member = pen.part(record, index);
            pen.store(member, value);
        }
        let next = pen.binary(BinaryOperator::Add, now, one);
        pen.store(count, next);
    });
    pen.push(Statement::Return { value: None });
    pen.finish();
    module.functions.append(function, naga::Span::UNDEFINED)
}

/// Calls the recorder for each scalar.
struct Recorder(Handle<Function>);

impl Probe for Recorder {
    fn after(&self, pen: &mut Pen<'_>, known: &Known<'_>) -> Handle<Expression> {
        for (site, (scalar, kind)) in (known.first + 1..).zip(split(pen, known.value, known.inner)) {
            let site = pen.literal(site);
            let zero = pen.declare(Expression::Literal(naga::Literal::F32(0.0)));
            let nothing = pen.literal(0);
            let (bits, number) = match kind {
                ScalarKind::Float => (nothing, scalar),
                ScalarKind::Bool => {
                    let one = pen.literal(1);
                    let bits = Expression::Select { condition: scalar, accept: one, reject: nothing };
                    (pen.compute(bits), zero)
                }
                ScalarKind::Sint => {
                    let bits = Expression::As { expr: scalar, kind: ScalarKind::Uint, convert: None };
                    (pen.compute(bits), zero)
                }
                _ => (scalar, zero),
            };
            pen.push(Statement::Call { function: self.0, arguments: vec![site, bits, number], result: None });
        }
        known.value
    }
}

/// The scalars of a value.
pub(super) fn split(
    pen: &mut Pen<'_>,
    value: Handle<Expression>,
    inner: &TypeInner,
) -> Vec<(Handle<Expression>, ScalarKind)> {
    match *inner {
        TypeInner::Scalar(scalar) => vec![(value, scalar.kind)],
        TypeInner::Vector { size, scalar } => {
            (0..size as u32).map(|i| (pen.part(value, i), scalar.kind)).collect()
        }
        TypeInner::Matrix { columns, rows, scalar } => {
            let column = TypeInner::Vector { size: rows, scalar };
            let columns: Vec<_> = (0..columns as u32).map(|i| pen.part(value, i)).collect();
            columns.into_iter().flat_map(|c| split(pen, c, &column)).collect()
        }
        _ => Vec::new(),
    }
}
