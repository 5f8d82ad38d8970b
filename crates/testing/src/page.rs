//! The contents of a page of steps, read as its script reads them.

use serde_json::Value;

/// The data in a page.
///
/// # Panics
/// If there is none.
pub fn data_of_page(page: &str) -> Value {
    let start = "<script type=\"application/json\" id=\"trace\">";
    let (_, rest) = page.split_once(start).expect("the data");
    let (json, _) = rest.split_once("</script>").expect("its end");
    serde_json::from_str(json).expect("JSON")
}

/// The heading and the sentence of each step.
///
/// # Panics
/// If the data are not those of a page.
pub fn words_of_steps(data: &Value) -> Vec<[String; 2]> {
    let text = |list: &str, at: &Value| {
        let at = usize::try_from(at.as_u64().expect("a number")).expect("a short list");
        data[list][at].clone()
    };
    let words = |step: &[Value]| {
        let heading = text("headings", &step[0]);
        let heading = heading[0].as_str().expect("a heading").to_owned();
        let sentence = text("sentences", &step[1]);
        let mut pieces = sentence.as_str().expect("a sentence").split('#');
        let mut sentence = pieces.next().unwrap_or_default().to_owned();
        for (piece, number) in pieces.zip(&step[2..]) {
            sentence += &format!("{number}{piece}");
        }
        [heading, sentence]
    };
    let list = |name: &str| data[name].as_array().expect("a list").clone();
    let sorted = list("sorted")
        .into_iter()
        .map(|v| words(&[0.into(), 0.into(), v]));
    let steps = list("steps");
    let others = steps
        .iter()
        .map(|step| words(step.as_array().expect("a list")));
    sorted.chain(others).collect()
}
