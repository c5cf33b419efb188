//! Files that an OBJ or MTL file names. Such names were written on another machine: with backslashes, in other case, with
//! folders that do not exist here.

use std::collections::HashMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// Looks for files; a folder is listed once.
#[derive(Default)]
pub(super) struct Finder {
    /// The files of each folder that was looked at, by their names in lower case.
    listings: HashMap<PathBuf, HashMap<String, OsString>>,
}

impl Finder {
    /// The file of this name: as it is written, in other case, or the last part of it within the folder itself.
    pub fn find(&mut self, folder: &Path, name: &str) -> Option<PathBuf> {
        let name = portable(name);
        let last = name.rsplit('/').next().unwrap_or(&name);
        let exact = [folder.join(&name), folder.join(last)].into_iter().find(|path| path.is_file());
        exact.or_else(|| self.in_other_case(folder, &name)).or_else(|| self.in_other_case(folder, last))
    }

    fn in_other_case(&mut self, folder: &Path, name: &str) -> Option<PathBuf> {
        let mut path = folder.to_path_buf();
        for part in name.split('/').filter(|part| !matches!(*part, "" | ".")) {
            let exact = path.join(part);
            path = if exact.exists() { exact } else { path.join(self.listing(&path).get(&part.to_lowercase())?) };
        }
        path.is_file().then_some(path)
    }

    fn listing(&mut self, folder: &Path) -> &HashMap<String, OsString> {
        self.listings.entry(folder.to_path_buf()).or_insert_with(|| {
            let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
            let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
            entries.map(|e| (e.file_name().to_string_lossy().to_lowercase(), e.file_name())).collect()
        })
    }
}

/// A name with slashes between folders and without quotation marks around it.
pub(super) fn portable(name: &str) -> String {
    let name = name.trim();
    name.strip_prefix('"').and_then(|n| n.strip_suffix('"')).unwrap_or(name).replace('\\', "/")
}
