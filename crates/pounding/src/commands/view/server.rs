//! A server for one page on this machine: one request a connection, everything within bounds.
//!
//! A request must name the server's own host, and the server's own origin if it names one. So a page from elsewhere reaches nothing, also by a
//! name that resolves to this machine. Calls need the token in a header, which no other page can set.

use std::io::{self, ErrorKind, Read, Write};
use std::net::{Ipv4Addr, Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use pounding::scene::hexadecimal;

/// Most bytes of the head of a request, and of its body.
const HEAD: usize = 16 << 10;
const BODY: usize = 64 << 10;
/// Most bytes of a record.
pub(super) const RECORD: usize = 8 << 20;
/// Most headers of a request: a browser sends some twenty.
const HEADERS: usize = 64;
/// Most connections at once: a browser opens six.
pub(super) const CONNECTIONS: usize = 32;
/// How long a request may take to arrive, and each part of an answer to leave.
const PATIENCE: Duration = Duration::from_secs(10);
/// How long a refused request is read on, so that its sender sees the refusal.
const DRAINED: Duration = Duration::from_millis(300);

/// The call whose body is a record behind a line of JSON.
pub(super) const RECORD_CALL: &str = "/api/record";

/// Header of the token.
const TOKEN: &str = "x-pounding-token";

/// Only files of this server, no frame around it, no request to elsewhere.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src data:; connect-src 'self'; base-uri 'none'; \
                      form-action 'none'; frame-ancestors 'none'";

/// A request that was let in.
#[derive(Debug)]
pub(super) enum Asked {
    /// A file of the page, by its path.
    File(String),
    /// A call with the token: its path and its body.
    Call(String, Vec<u8>),
}

/// An answer.
#[derive(Debug)]
pub(super) struct Reply {
    status: u16,
    kind: &'static str,
    body: Vec<u8>,
}

impl Reply {
    /// A file or a result, with its type.
    pub(super) fn of(kind: &'static str, body: impl Into<Vec<u8>>) -> Self {
        let body = body.into();
        Self { status: 200, kind, body }
    }

    /// A refusal in words.
    pub(super) fn refused(status: u16, why: impl Into<String>) -> Self {
        Self {
            status,
            kind: "text/plain; charset=utf-8",
            body: why.into().into_bytes(),
        }
    }

    fn send(&self, to: &mut TcpStream) -> io::Result<()> {
        let reason = if self.status == 200 { "OK" } else { "Refused" };
        let head = format!(
            "HTTP/1.1 {} {reason}\r\nContent-Type: {}\r\nContent-Length: {}\r\nConnection: close\r\nCache-Control: no-store\r\n\
             Content-Security-Policy: {POLICY}\r\nX-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n\
             Cross-Origin-Resource-Policy: same-origin\r\n\r\n",
            self.status,
            self.kind,
            self.body.len(),
        );
        to.write_all(head.as_bytes())?;
        to.write_all(&self.body)
    }
}

/// The server: it listens on the loopback address alone.
#[derive(Debug)]
pub(super) struct Server {
    listener: TcpListener,
    /// Host as requests name it, with the port.
    host: String,
    token: String,
}

impl Server {
    /// Takes a free port and makes a token.
    ///
    /// # Errors
    /// Errors of the system.
    pub(super) fn open() -> io::Result<Self> {
        let listener = TcpListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, 0)))?;
        let mut random = [0; 16];
        getrandom::fill(&mut random).map_err(io::Error::other)?;
        Ok(Self {
            host: listener.local_addr()?.to_string(),
            token: hexadecimal(&random),
            listener,
        })
    }

    /// Address of the page. The token stands behind `#`, which a browser does not send.
    pub(super) fn address(&self) -> String {
        format!("http://{}/#token={}", self.host, self.token)
    }

    /// Answers requests until the process ends.
    pub(super) fn serve(self, answer: impl Fn(Asked) -> Reply + Send + Sync + 'static) {
        let (server, answer, open) = (Arc::new(self), Arc::new(answer), Arc::new(AtomicUsize::new(0)));
        loop {
            let Ok((mut stream, _)) = server.listener.accept() else {
                // No more files may be open: a moment later there may be.
                thread::sleep(Duration::from_millis(20));
                continue;
            };
            let place = Place(Arc::clone(&open));
            if open.fetch_add(1, Ordering::SeqCst) >= CONNECTIONS {
                let _ = stream.set_write_timeout(Some(Duration::from_millis(50)));
                let _ = Reply::refused(503, "too many requests at once").send(&mut stream);
                continue;
            }
            let (server, answer) = (Arc::clone(&server), Arc::clone(&answer));
            let started = thread::Builder::new().spawn(move || {
                let _place = place;
                // A sender that has gone hears no answer.
                let _ = server.converse(&mut stream, &*answer);
            });
            drop(started);
        }
    }

    fn converse(&self, stream: &mut TcpStream, answer: &dyn Fn(Asked) -> Reply) -> io::Result<()> {
        stream.set_write_timeout(Some(PATIENCE))?;
        let asked = self.read(stream, Instant::now() + PATIENCE)?;
        let is_refused = asked.is_err();
        let reply = asked.map_or_else(|refused| refused, answer);
        reply.send(stream)?;
        stream.shutdown(Shutdown::Write)?;
        if is_refused {
            drain(stream);
        }
        Ok(())
    }

    /// Reads a request and lets it in or refuses it.
    fn read(&self, stream: &mut TcpStream, until: Instant) -> io::Result<Result<Asked, Reply>> {
        let mut bytes = Vec::new();
        let (head, length) = loop {
            let mut headers = [httparse::EMPTY_HEADER; HEADERS];
            let mut request = httparse::Request::new(&mut headers);
            match request.parse(&bytes) {
                Ok(httparse::Status::Complete(length)) if length <= HEAD => break (Head::of(&request), length),
                Ok(_) if bytes.len() > HEAD => return Ok(Err(Reply::refused(431, "the head is too long"))),
                Ok(_) => {}
                Err(error) => return Ok(Err(Reply::refused(400, format!("no request: {error}")))),
            }
            more(stream, &mut bytes, until)?;
        };
        let length_of_body = match self.admit(&head) {
            Ok(length) => length,
            Err(refused) => return Ok(Err(refused)),
        };
        while bytes.len() < length + length_of_body {
            more(stream, &mut bytes, until)?;
        }
        bytes.truncate(length + length_of_body);
        Ok(Ok(if head.is_call() {
            Asked::Call(head.path, bytes.split_off(length))
        } else {
            Asked::File(head.path)
        }))
    }

    /// Length of the body of a request that may be answered.
    fn admit(&self, head: &Head) -> Result<usize, Reply> {
        let only = |name: &str| match &head.all(name)[..] {
            [] => Ok(None),
            [one] => Ok(Some((*one).to_owned())),
            _ => Err(Reply::refused(400, format!("several headers `{name}`"))),
        };
        if only("host")?.as_deref() != Some(&self.host) {
            return Err(Reply::refused(403, "another host"));
        }
        let own = format!("http://{}", self.host);
        if only("origin")?.is_some_and(|origin| origin != own) {
            return Err(Reply::refused(403, "another origin"));
        }
        if !head.all("transfer-encoding").is_empty() {
            return Err(Reply::refused(411, "the length is not told"));
        }
        let length = only("content-length")?.map_or(Ok(0), |length| length.parse::<usize>());
        let length = length.map_err(|_| Reply::refused(400, "no length"))?;
        match (head.method.as_str(), head.is_call()) {
            ("POST", true) if !self.knows(&only(TOKEN)?.unwrap_or_default()) => {
                Err(Reply::refused(403, "another token: open the address that `pounding view` prints"))
            }
            ("POST", true) if length > BODY + if head.path == RECORD_CALL { RECORD } else { 0 } => {
                Err(Reply::refused(413, "the request is too long"))
            }
            ("POST", true) => Ok(length),
            ("GET", false) if length == 0 => Ok(0),
            _ => Err(Reply::refused(405, "GET of a file, or POST to /api/")),
        }
    }

    /// Whether this is the token. The comparison takes the same time wherever they differ.
    fn knows(&self, token: &str) -> bool {
        let (own, other) = (self.token.as_bytes(), token.as_bytes());
        let differs = own.iter().zip(other).fold(0, |differs, (own, other)| differs | (own ^ other));
        own.len() == other.len() && differs == 0
    }
}

/// A place among the connections, which is free again when it is dropped.
struct Place(Arc<AtomicUsize>);

impl Drop for Place {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}

/// The head of a request.
struct Head {
    method: String,
    path: String,
    headers: Vec<(String, String)>,
}

impl Head {
    fn of(request: &httparse::Request<'_, '_>) -> Self {
        let headers = request.headers.iter();
        let headers = headers.map(|header| {
            let value = String::from_utf8_lossy(header.value);
            (header.name.to_ascii_lowercase(), value.into_owned())
        });
        Self {
            method: request.method.unwrap_or_default().into(),
            path: request.path.unwrap_or_default().into(),
            headers: headers.collect(),
        }
    }

    fn all(&self, name: &str) -> Vec<&str> {
        let own = self.headers.iter().filter(|(known, _)| known == name);
        own.map(|(_, value)| value.as_str()).collect()
    }

    /// Whether it asks for something to be done.
    fn is_call(&self) -> bool {
        self.path.starts_with("/api/")
    }
}

/// Reads what has arrived, before a deadline.
fn more(stream: &mut TcpStream, bytes: &mut Vec<u8>, until: Instant) -> io::Result<()> {
    let left = until.saturating_duration_since(Instant::now());
    if left.is_zero() {
        return Err(ErrorKind::TimedOut.into());
    }
    stream.set_read_timeout(Some(left))?;
    let mut buffer = [0; 8 << 10];
    match stream.read(&mut buffer)? {
        0 => Err(ErrorKind::UnexpectedEof.into()),
        n => {
            bytes.extend_from_slice(&buffer[..n]);
            Ok(())
        }
    }
}

/// Reads on for a moment: a connection that is closed with unread bytes loses the answer.
fn drain(stream: &mut TcpStream) {
    let until = Instant::now() + DRAINED;
    let mut unread = Vec::new();
    while more(stream, &mut unread, until).is_ok() {
        unread.clear();
    }
}
