//! `#[derive(Lanes)]`: how the parameters of several contacts are put side by side, one per vector lane.
use proc_macro::TokenStream;
use proc_macro2::TokenStream as Tokens;
use quote::{format_ident, quote};
use syn::{parse_macro_input, Data, DeriveInput, Error, Fields, GenericParam, Ident, Type};

/// Implements `granlaw::lane::Lanes` for a struct with named fields whose first type parameter is the number:
///
/// ```text
/// #[derive(Clone, Copy, Debug, Lanes)]
/// pub struct Params<L = f64> {
///     kn: L,                     // one number per lane
///     torque: ConstantTorque<L>, // a struct that derives Lanes too
///     limit_force: bool,         // a switch: the same for all contacts of a chain
/// }
/// ```
///
/// A further type parameter stands for parameters that implement `Lanes` themselves.
#[proc_macro_derive(Lanes)]
pub fn derive_lanes(input: TokenStream) -> TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    lanes(&input).unwrap_or_else(|e| e.to_compile_error()).into()
}

fn lanes(input: &DeriveInput) -> Result<Tokens, Error> {
    let name = &input.ident;
    let types: Vec<&Ident> = input
        .generics
        .params
        .iter()
        .map(|p| match p {
            GenericParam::Type(t) => Ok(&t.ident),
            other => Err(Error::new_spanned(other, "Lanes: only type parameters are allowed")),
        })
        .collect::<Result<_, _>>()?;
    let Some((number, more)) = types.split_first() else {
        return Err(Error::new_spanned(
            name,
            "Lanes: the first type parameter must be the number, as in Params<L = f64>",
        ));
    };
    let Data::Struct(data) = &input.data else {
        return Err(Error::new_spanned(name, "Lanes: only structs are allowed"));
    };
    let Fields::Named(fields) = &data.fields else {
        return Err(Error::new_spanned(name, "Lanes: the fields must have names"));
    };
    let values = fields.named.iter().map(|f| {
        let field = f.ident.as_ref().expect("a named field");
        let value = side_by_side(field, &f.ty, number, more);
        quote!(#field: #value)
    });
    // The lane of the trait's own signatures must not be mistaken for a parameter of the struct.
    let lane = format_ident!("GranlawLane");
    Ok(quote! {
        impl<#(#more: ::granlaw::lane::Lanes),*> ::granlaw::lane::Lanes for #name<f64, #(#more),*> {
            type Of<#lane: ::granlaw::lane::Lane> = #name<#lane, #(<#more as ::granlaw::lane::Lanes>::Of<#lane>),*>;
            #[inline(always)]
            fn side_by_side<#lane: ::granlaw::lane::Lane>(of: impl Fn(usize) -> Self) -> Self::Of<#lane> {
                #name { #(#values),* }
            }
        }
    })
}

/// One field of all lanes.
fn side_by_side(field: &Ident, ty: &Type, number: &Ident, more: &[&Ident]) -> Tokens {
    let lanes = quote!(::granlaw::lane::Lanes);
    match ty {
        Type::Path(path) if path.path.is_ident(number) => {
            quote!(::granlaw::lane::Lane::from_fn(#[inline(always)] |k| of(k).#field))
        }
        Type::Path(path) if more.iter().any(|m| path.path.is_ident(*m)) => {
            quote!(<#ty as #lanes>::side_by_side(#[inline(always)] |k| of(k).#field))
        }
        _ if mentions(quote!(#ty), number) => {
            let alone = replaced(quote!(#ty), number);
            quote!(<#alone as #lanes>::side_by_side(#[inline(always)] |k| of(k).#field))
        }
        _ => quote!(of(0).#field),
    }
}

fn mentions(tokens: Tokens, name: &Ident) -> bool {
    tokens.into_iter().any(|t| match t {
        proc_macro2::TokenTree::Ident(i) => i == *name,
        proc_macro2::TokenTree::Group(g) => mentions(g.stream(), name),
        _ => false,
    })
}

/// The type of a single contact: `f64` in place of the number.
fn replaced(tokens: Tokens, name: &Ident) -> Tokens {
    let one = |t| match t {
        proc_macro2::TokenTree::Ident(i) if i == *name => quote!(f64),
        proc_macro2::TokenTree::Group(g) => {
            let inner = proc_macro2::Group::new(g.delimiter(), replaced(g.stream(), name));
            proc_macro2::TokenTree::Group(inner).into()
        }
        other => Tokens::from(other),
    };
    tokens.into_iter().flat_map(one).collect()
}
