//! Files that a crate makes: what each is, and what is in it. Where they go is decided elsewhere.

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct File {
    pub name: String,
    /// What it is, in a few words.
    pub about: &'static str,
    pub content: Content,
}

impl File {
    /// A file of text.
    pub fn text(name: impl Into<String>, about: &'static str, text: String) -> Self {
        Self {
            name: name.into(),
            about,
            content: Content::Text(text),
        }
    }

    /// A file of bytes.
    pub fn bytes(name: impl Into<String>, about: &'static str, bytes: Vec<u8>) -> Self {
        Self {
            name: name.into(),
            about,
            content: Content::Bytes(bytes),
        }
    }
}

/// What is in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Content {
    Text(String),
    Bytes(Vec<u8>),
}

impl Content {
    /// The bytes of the file.
    pub fn bytes(&self) -> &[u8] {
        match self {
            Self::Text(text) => text.as_bytes(),
            Self::Bytes(bytes) => bytes,
        }
    }
}
