//! As much of JSON Schema as `tests/conformance/schema.json` uses.

use serde_json::{Map, Value};

/// Whether a value is as a schema says, whose references are to `root`.
pub(crate) fn conforms(value: &Value, schema: &Value, root: &Value) -> Result<(), String> {
    let rules = schema.as_object().ok_or("a schema is an object")?;
    for (rule, wanted) in rules {
        let holds = match rule.as_str() {
            "$ref" => {
                let place = wanted.as_str().and_then(|place| place.strip_prefix('#'));
                let referred = place
                    .and_then(|place| root.pointer(place))
                    .ok_or("no such place")?;
                conforms(value, referred, root)?;
                true
            }
            "type" => match wanted.as_str() {
                Some("object") => value.is_object(),
                Some("array") => value.is_array(),
                Some("string") => value.is_string(),
                Some("number") => value.is_number(),
                Some("integer") => value.is_i64() || value.is_u64(),
                _ => return Err(format!("the type {wanted} is not known here")),
            },
            "enum" => wanted.as_array().is_some_and(|all| all.contains(value)),
            "minimum" => value.as_f64() >= wanted.as_f64(),
            "minItems" => length(value) >= wanted.as_u64(),
            "maxItems" => length(value) <= wanted.as_u64(),
            "items" => {
                for item in value.as_array().into_iter().flatten() {
                    conforms(item, wanted, root)?;
                }
                true
            }
            "required" => {
                let mut names = wanted
                    .as_array()
                    .into_iter()
                    .flatten()
                    .filter_map(Value::as_str);
                names.all(|name| value.get(name).is_some())
            }
            "properties" => {
                for (name, schema) in wanted.as_object().into_iter().flatten() {
                    if let Some(member) = value.get(name) {
                        conforms(member, schema, root)
                            .map_err(|error| format!("{name}: {error}"))?;
                    }
                }
                true
            }
            "additionalProperties" => {
                let known = rules.get("properties").and_then(Value::as_object);
                let is_known =
                    |name: &String| known.is_some_and(|known: &Map<_, _>| known.contains_key(name));
                value
                    .as_object()
                    .is_none_or(|members| members.keys().all(is_known))
            }
            "oneOf" => {
                let all = wanted.as_array().into_iter().flatten();
                all.filter(|schema| conforms(value, schema, root).is_ok())
                    .count()
                    == 1
            }
            "$schema" | "$defs" | "title" | "description" => true,
            _ => return Err(format!("the rule {rule} is not known here")),
        };
        if !holds {
            return Err(format!("{rule} {wanted} does not hold of {value}"));
        }
    }
    Ok(())
}

fn length(value: &Value) -> Option<u64> {
    value
        .as_array()
        .and_then(|list| u64::try_from(list.len()).ok())
}
