//! The text of OBJ and MTL files: bytes to characters, characters to lines, words to numbers. Both formats share what
//! exporters do to them: byte order marks, three kinds of line ends, decimal commas, numbers that are none.

use std::borrow::Cow;

/// The characters of a file. A byte order mark is left out; what is not UTF-8 is read as UTF-16 if its mark says so, and
/// else as Latin-1, as most older files with accents in their names are.
pub(super) fn decode(bytes: &[u8]) -> Cow<'_, str> {
    let utf16 = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let units = bytes.as_chunks::<2>().0.iter().map(|&b| unit(b));
        Cow::Owned(char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect())
    };
    match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => String::from_utf8_lossy(rest),
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes),
        _ => match std::str::from_utf8(bytes) {
            Ok(text) => Cow::Borrowed(text),
            Err(_) => Cow::Owned(bytes.iter().map(|&b| char::from(b)).collect()),
        },
    }
}

/// A statement: the line it begins in, its keyword, and what follows (with comments, which names may look like).
pub(super) struct Statement<'a> {
    pub line: usize,
    pub keyword: Cow<'a, str>,
    pub rest: Cow<'a, str>,
}

/// The statements of a text, without empty lines and lines of comment. A line ends in LF, CR LF or CR; one that ends in a
/// backslash goes on in the next.
pub(super) fn statements(text: &str) -> impl Iterator<Item = Statement<'_>> {
    let mut lines = physical_lines(text).enumerate();
    std::iter::from_fn(move || {
        loop {
            let (at, first) = lines.next()?;
            let first = first.trim();
            if first.is_empty() || first.starts_with('#') {
                continue;
            }
            let (mut joined, mut open) = continued(first);
            while open {
                let Some((_, next)) = lines.next() else { break };
                let (text, more) = continued(next.trim());
                let whole = joined.to_mut();
                whole.push(' ');
                whole.push_str(&text);
                open = more;
            }
            let (keyword, rest) = match joined {
                Cow::Borrowed(line) => {
                    let (keyword, rest) = word(line);
                    (Cow::Borrowed(keyword), Cow::Borrowed(rest))
                }
                Cow::Owned(line) => {
                    let (keyword, rest) = word(&line);
                    (Cow::Owned(keyword.to_owned()), Cow::Owned(rest.to_owned()))
                }
            };
            return Some(Statement { line: at + 1, keyword, rest });
        }
    })
}

fn physical_lines(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let text = rest?;
        let Some(end) = text.find(['\n', '\r']) else {
            rest = None;
            return Some(text);
        };
        let (line, after) = text.split_at(end);
        rest = Some(after.strip_prefix("\r\n").or_else(|| after.get(1..)).unwrap_or(""));
        Some(line)
    })
}

fn continued(line: &str) -> (Cow<'_, str>, bool) {
    line.strip_suffix('\\').map_or((Cow::Borrowed(line), false), |text| (Cow::Borrowed(text.trim_end()), true))
}

/// The first word and what follows it.
pub(super) fn word(text: &str) -> (&str, &str) {
    let text = text.trim_start();
    text.split_once(char::is_whitespace).map_or((text, ""), |(word, rest)| (word, rest.trim()))
}

/// A name without what may be a comment behind it. A `#` after a blank can be either: try the whole name first.
pub(super) fn without_comment(name: &str) -> &str {
    name.match_indices('#')
        .find(|(at, _)| name[..*at].ends_with(char::is_whitespace))
        .map_or(name, |(at, _)| name[..at].trim_end())
}

/// The words of a statement that holds numbers. A `#` begins a comment, except in what Microsoft's library prints for
/// numbers that are none (`-1.#IND00`).
pub(super) fn words(rest: &str) -> impl Iterator<Item = &str> {
    let comment = rest.match_indices('#').map(|(at, _)| at).find(|&at| {
        let after = rest.get(at + 1..at + 4).unwrap_or("");
        !["IND", "INF", "QNA", "SNA"].iter().any(|kind| after.eq_ignore_ascii_case(kind))
    });
    rest[..comment.unwrap_or(rest.len())].split_whitespace()
}

/// A number that an f32 can hold, or what is wrong with it. A comma in the place of the point is taken as one.
pub(super) fn number(word: &str) -> Result<f64, String> {
    let not_finite = || Err(format!("`{}` is not a finite number", short(word)));
    match word.parse::<f64>().or_else(|_| word.trim_end_matches(',').replacen(',', ".", 1).parse()) {
        Ok(value) if (value as f32).is_finite() => Ok(value),
        Ok(_) => not_finite(),
        Err(_) if word.contains(".#") || word.to_ascii_lowercase().contains("nan(") => not_finite(),
        Err(_) => Err(format!("`{}` is not a number", short(word))),
    }
}

/// The first `N` numbers of a statement.
pub(super) fn numbers<const N: usize>(rest: &str) -> Result<[f64; N], String> {
    let mut all = [0.0; N];
    let mut words = words(rest);
    for (i, place) in all.iter_mut().enumerate() {
        let word = words.next().ok_or_else(|| format!("{N} numbers are needed, there are {i}"))?;
        *place = number(word)?;
    }
    Ok(all)
}

/// A word as a message shows it.
pub(super) fn short(word: &str) -> Cow<'_, str> {
    match word.char_indices().nth(40) {
        Some((end, _)) => Cow::Owned(format!("{}...", &word[..end])),
        None => Cow::Borrowed(word),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_encoding_and_line_end_gives_the_same_statements() {
        let utf16 = |unit: fn(u16) -> [u8; 2], mark: [u8; 2], text: &str| {
            [&mark[..], &text.encode_utf16().flat_map(unit).collect::<Vec<u8>>()].concat()
        };
        let text = "v 1 2 3\no é\nf 1\\\n 2";
        for bytes in [
            text.as_bytes().to_vec(),
            [&[0xef, 0xbb, 0xbf], text.as_bytes()].concat(),
            utf16(u16::to_le_bytes, [0xff, 0xfe], text),
            utf16(u16::to_be_bytes, [0xfe, 0xff], text),
            text.chars().map(|c| c as u8).collect(),
            text.replace('\n', "\r").into_bytes(),
            text.replace('\n', "\r\n").into_bytes(),
        ] {
            let text = decode(&bytes);
            let all: Vec<_> =
                statements(&text).map(|s| (s.line, s.keyword.into_owned(), s.rest.into_owned())).collect();
            let expected = [(1, "v", "1 2 3"), (2, "o", "é"), (3, "f", "1 2")].map(|(l, k, r)| (l, k.into(), r.into()));
            assert_eq!(all, expected);
        }
    }

    #[test]
    fn numbers_are_read_as_exporters_write_them() {
        for (word, value) in [("-.5", -0.5), ("5.", 5.0), ("+1e2", 100.0), ("1,5", 1.5), ("2,", 2.0), ("0.1", 0.1)] {
            assert_eq!(number(word), Ok(value));
        }
        for word in ["nan", "-inf", "1e39", "-1.#IND00", "1.#QNAN", "1.#INF00", "-nan(ind)"] {
            assert_eq!(number(word), Err(format!("`{word}` is not a finite number")));
        }
        for word in ["x", "1,2,3", "0x10", "1.5f"] {
            assert_eq!(number(word), Err(format!("`{word}` is not a number")));
        }
        assert_eq!(words("1 -1.#IND00 2#3 # 4 5").collect::<Vec<_>>(), ["1", "-1.#IND00", "2"]);
        assert_eq!(numbers::<2>("1 # 2"), Err("2 numbers are needed, there are 1".into()));
    }

    #[test]
    fn a_comment_behind_a_name_can_be_told_off() {
        assert_eq!((without_comment("red # the red one"), without_comment("a#b")), ("red", "a#b"));
        assert_eq!(without_comment("Material #25"), "Material");
    }
}
