//! Which file of `src` uses which: the graph of the paths that begin with `crate`, `super`, `self` or a child module, read
//! from the text. What a module re-exports counts as used where it is defined. Comments, strings and `#[cfg(test)]`
//! modules do not count.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The modules of the crate by their path (`fragment::batch`; the root is empty).
pub struct Graph {
    modules: BTreeMap<String, Module>,
}

#[derive(Default)]
struct Module {
    file: String,
    text: String,
    /// Where inline modules stand in the text.
    inline: Vec<std::ops::Range<usize>>,
    children: BTreeSet<String>,
    /// Names that are re-exported, and the paths they stand for; `*` for all of a module.
    exports: Vec<(String, Vec<String>)>,
}

impl Graph {
    /// Reads the files of a folder `src`.
    pub fn read(src: &Path) -> Graph {
        let mut graph = Graph { modules: BTreeMap::new() };
        graph.add(src, "", &src.join("lib.rs"), src);
        let paths: Vec<String> = graph.modules.keys().cloned().collect();
        for path in &paths {
            let exports = graph.paths(path, true).into_iter().map(|p| (p.last().cloned().unwrap_or_default(), p));
            let exports = exports.collect();
            graph.modules.get_mut(path).expect("a module").exports = exports;
        }
        graph
    }

    /// A module and, for each `mod child;` that is not for tests, its children.
    fn add(&mut self, src: &Path, path: &str, file: &Path, folder: &Path) {
        let text = without_tests(&code(&fs::read_to_string(file).expect("a source file")));
        let mut module = Module {
            file: file.strip_prefix(src).expect("a file of src").display().to_string(),
            inline: inline(&text),
            ..Module::default()
        };
        for (at, _) in text.match_indices("mod ") {
            let name: String = text[at + 4..].chars().take_while(|c| is_word(*c)).collect();
            if text[..at].ends_with(is_word) || !text[at + 4 + name.len()..].starts_with(';') {
                continue;
            }
            let [flat, deep] = [folder.join(format!("{name}.rs")), folder.join(&name).join("mod.rs")];
            let child = if flat.exists() { flat } else { deep };
            if child.exists() {
                self.add(src, &joined(path, &name), &child, &folder.join(&name));
                module.children.insert(name);
            }
        }
        module.text = text;
        self.modules.insert(path.to_string(), module);
    }

    /// The paths in a module that lead to modules of the crate: those that it re-exports, or the others.
    fn paths(&self, of: &str, exported: bool) -> Vec<Vec<String>> {
        let module = &self.modules[of];
        let text = &module.text;
        let mut found = Vec::new();
        let starts = ["crate", "super", "self"].into_iter().chain(module.children.iter().map(String::as_str));
        for start in starts {
            for (at, _) in text.match_indices(&format!("{start}::")) {
                let before = &text[..at];
                if before.ends_with(|c| is_word(c) || c == ':') || inside_tree(before) {
                    continue;
                }
                let statement = before.rsplit([';', '}', '{']).next().unwrap_or_default().trim();
                let is_export = statement.starts_with("pub") && statement.ends_with("use");
                if is_export != exported {
                    continue;
                }
                let deep = module.inline.iter().filter(|range| range.contains(&at)).count();
                tree(&text[at..], &mut Vec::new(), &mut |path| found.extend(self.absolute(of, deep, path)));
            }
        }
        found
    }

    /// A path from the root of the crate, without `crate`. None where it stays within an inline module.
    fn absolute(&self, of: &str, mut deep: usize, path: &[String]) -> Option<Vec<String>> {
        let mut from: Vec<String> = of.split("::").filter(|s| !s.is_empty()).map(String::from).collect();
        let mut rest = path;
        match rest.first().map(String::as_str)? {
            "crate" => (from, rest) = (Vec::new(), &rest[1..]),
            "self" if deep > 0 => return None,
            "self" => rest = &rest[1..],
            _ => {}
        }
        while rest.first().is_some_and(|s| s == "super") {
            if deep > 0 {
                deep -= 1;
            } else {
                from.pop();
            }
            rest = &rest[1..];
        }
        from.extend_from_slice(rest);
        Some(from)
    }

    /// The module in which what a path names is defined.
    fn home(&self, path: &[String], depth: usize) -> Option<String> {
        let known = (0..=path.len()).rev().find(|n| self.modules.contains_key(&path[..*n].join("::")))?;
        let module = path[..known].join("::");
        let Some(name) = path.get(known).filter(|name| *name != "*" && depth < 8) else { return Some(module) };
        let exports = &self.modules[&module].exports;
        let through = exports.iter().find(|(export, to)| export == name && to[..] != path[..]).or_else(|| {
            exports.iter().find(|(export, to)| {
                export == "*" && self.modules.get(&to[..to.len() - 1].join("::")).is_some_and(|m| m.defines(name))
            })
        });
        match through {
            Some((export, to)) => {
                let to = if export == "*" { &to[..to.len() - 1] } else { &to[..] };
                let whole: Vec<String> =
                    to.iter().chain(&path[known + usize::from(export != "*")..]).cloned().collect();
                self.home(&whole, depth + 1)
            }
            None => Some(module),
        }
    }

    /// For each file, those that it uses.
    pub fn uses(&self) -> BTreeMap<&str, BTreeSet<&str>> {
        let uses = |(path, module): (&String, &'_ Module)| {
            let homes = self.paths(path, false).iter().filter_map(|used| self.home(used, 0)).collect::<BTreeSet<_>>();
            let files = homes.iter().map(|home| self.modules[home].file.as_str());
            let used = files.filter(|file| *file != module.file).collect::<BTreeSet<_>>();
            (path.clone(), used)
        };
        self.modules.iter().map(uses).map(|(path, used)| (self.modules[&path].file.as_str(), used)).collect()
    }

    /// The circles: sets of files each of which leads to each other, the largest first.
    pub fn circles(&self) -> Vec<Vec<&str>> {
        let uses = self.uses();
        let reach = |from: &'_ str| {
            let mut seen = BTreeSet::new();
            let mut open: Vec<&str> = uses[from].iter().copied().collect();
            while let Some(file) = open.pop() {
                if seen.insert(file) {
                    open.extend(&uses[file]);
                }
            }
            seen
        };
        let reached: BTreeMap<&str, BTreeSet<&str>> = uses.keys().map(|file| (*file, reach(file))).collect();
        let mut circles = BTreeSet::new();
        for (file, there) in &reached {
            let circle: Vec<&str> = there.iter().copied().filter(|other| reached[other].contains(file)).collect();
            if circle.len() > 1 {
                circles.insert(circle);
            }
        }
        let mut circles: Vec<Vec<&str>> = circles.into_iter().collect();
        circles.sort_by_key(|circle| std::cmp::Reverse(circle.len()));
        circles
    }
}

impl Module {
    /// Whether an item of a name is defined in the module itself.
    fn defines(&self, name: &str) -> bool {
        ["struct", "enum", "fn", "const", "static", "trait", "type", "union", "macro_rules!", "use"].iter().any(
            |kind| {
                let head = format!("{kind} {name}");
                self.text.match_indices(&head).any(|(at, _)| !self.text[at + head.len()..].starts_with(is_word))
            },
        )
    }
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn joined(path: &str, name: &str) -> String {
    if path.is_empty() { name.to_string() } else { format!("{path}::{name}") }
}

/// Whether a text ends within the braces of a use, where names belong to what stands before the brace.
fn inside_tree(before: &str) -> bool {
    let mut closed = 0;
    for (at, c) in before.char_indices().rev() {
        match c {
            '}' => closed += 1,
            '{' if closed > 0 => closed -= 1,
            '{' => return before[..at].ends_with("::"),
            ';' => return false,
            _ => {}
        }
    }
    false
}

/// Calls back for each path of a tree such as `a::{b, c::{d, e}}`. Returns how much of the text it takes.
fn tree(text: &str, path: &mut Vec<String>, found: &mut dyn FnMut(&[String])) -> usize {
    let depth = path.len();
    let mut at = 0;
    loop {
        let rest = &text[at..];
        if let Some(inner) = rest.strip_prefix('{') {
            let mut inside = at + 1;
            loop {
                inside += text[inside..].len() - text[inside..].trim_start().len();
                match text[inside..].chars().next() {
                    Some('}') | None => break,
                    Some(',') => inside += 1,
                    Some(_) => {
                        let taken = tree(&text[inside..], path, found);
                        if taken == 0 {
                            break;
                        }
                        inside += taken;
                        let until = text[inside..].find([',', '}']).unwrap_or(inner.len().min(text.len() - inside));
                        inside += until;
                    }
                }
            }
            at = (inside + 1).min(text.len());
            break;
        }
        let word: String = rest.chars().take_while(|c| is_word(*c) || *c == '*').collect();
        if word.is_empty() {
            break;
        }
        at += word.len();
        path.push(word);
        if text[at..].starts_with("::") {
            at += 2;
        } else {
            found(path);
            break;
        }
    }
    path.truncate(depth);
    at
}

/// The text without comments, and with empty strings.
fn code(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '/' if chars.peek() == Some(&'/') => {
                chars.by_ref().find(|c| *c == '\n');
                out.push('\n');
            }
            '"' => {
                while let Some(inside) = chars.next() {
                    match inside {
                        '\\' => _ = chars.next(),
                        '"' => break,
                        _ => {}
                    }
                }
                out.push_str("\"\"");
            }
            '\'' if matches!(chars.peek(), Some('"' | '{' | '}')) => _ = (chars.next(), chars.next()),
            _ => out.push(c),
        }
    }
    out
}

/// Where a block that is opened at or after a place ends.
fn block_end(text: &str, from: usize) -> usize {
    let mut open = 0usize;
    for (at, c) in text[from..].char_indices() {
        match c {
            '{' => open += 1,
            '}' if open == 1 => return from + at + 1,
            '}' => open = open.saturating_sub(1),
            _ => {}
        }
    }
    text.len()
}

/// The text without items that are only there for tests.
fn without_tests(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find("#[cfg(test)]") {
        out.push_str(&rest[..at]);
        let after = &rest[at..];
        let end = match after.find(['{', ';']) {
            Some(end) if after.as_bytes()[end] == b'{' => block_end(after, end),
            Some(end) => end + 1,
            None => after.len(),
        };
        rest = &after[end..];
    }
    out + rest
}

/// Where the inline modules stand.
fn inline(text: &str) -> Vec<std::ops::Range<usize>> {
    let opens = text.match_indices("mod ").filter(|(at, _)| {
        let name = text[at + 4..].trim_start_matches(is_word);
        !text[..*at].ends_with(is_word) && name.starts_with(" {")
    });
    opens.map(|(at, _)| at..block_end(text, at)).collect()
}
