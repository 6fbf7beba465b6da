//! A site on this machine, a browser that visits it, and what its pages send back.

use lobe_backends::translate::web;
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::{Duration, Instant};

/// What a site consists of.
#[derive(Debug, Default)]
pub(crate) struct Site {
    /// Texts by path, as `/index.html`.
    pub(crate) texts: BTreeMap<String, String>,
    /// Folders by the path that they lie under, as `/node_modules/`.
    pub(crate) folders: Vec<(&'static str, PathBuf)>,
}

/// What a page draws and computes with, on a driver of the browser's own.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Gpu {
    WebGpu,
    WebGl,
}

impl Gpu {
    fn options(self) -> &'static [&'static str] {
        match self {
            Self::WebGpu => &["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader"],
            Self::WebGl => {
                &["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
            }
        }
    }
}

/// What pages sent to `/sent/NAME`, by name.
pub(crate) type Sent = BTreeMap<String, Vec<u8>>;

/// What the browser may take: its own drivers compile on one thread.
const PATIENCE: Duration = Duration::from_secs(300);

impl Site {
    /// Shows a page in a browser until the page has sent `done`.
    #[track_caller]
    pub(crate) fn visit(self, page: &str, gpu: Gpu) -> Sent {
        let listener = TcpListener::bind(("127.0.0.1", 0)).expect("a port");
        let address = listener.local_addr().expect("an address");
        let is_over = Arc::new(AtomicBool::new(false));
        let (sender, receiver) = channel();
        let served = std::thread::spawn({
            let (site, is_over) = (Arc::new(self), Arc::clone(&is_over));
            move || serve(&listener, &site, &is_over, &sender)
        });
        let profile = tempfile::tempdir().expect("a folder");
        let mut browser = browser(&format!("http://{address}{page}"), gpu, profile.path());
        let sent = collect(&receiver, &mut browser);
        let _ = browser.kill();
        let _ = browser.wait();
        is_over.store(true, Ordering::Relaxed);
        // The server looks up when somebody comes.
        let _ = TcpStream::connect(address);
        served.join().expect("the server");
        sent.unwrap_or_else(|why| panic!("{page}: {why}"))
    }
}

fn browser(url: &str, gpu: Gpu, profile: &std::path::Path) -> Child {
    let program = web::browser().unwrap_or_else(|e| panic!("{e}"));
    Command::new(program)
        .args(["--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-sync"])
        .args(["--disable-background-networking", "--disable-component-update", "--window-size=800,600"])
        .args(gpu.options())
        .args([format!("--user-data-dir={}", profile.display()), url.to_owned()])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the browser starts")
}

fn collect(receiver: &Receiver<(String, Vec<u8>)>, browser: &mut Child) -> Result<Sent, String> {
    let end = Instant::now() + PATIENCE;
    let mut sent = Sent::new();
    while !sent.contains_key("done") {
        match receiver.recv_timeout(Duration::from_millis(500)) {
            Ok((name, body)) => {
                sent.insert(name, body);
            }
            Err(RecvTimeoutError::Disconnected) => return Err("the server ended".to_owned()),
            Err(RecvTimeoutError::Timeout) if Instant::now() > end => {
                return Err(format!("not done after {PATIENCE:?}; it sent {:?}", sent.keys()));
            }
            Err(RecvTimeoutError::Timeout) => {
                if let Some(status) = browser.try_wait().map_err(|e| e.to_string())? {
                    return Err(format!("the browser ended: {status}"));
                }
            }
        }
    }
    Ok(sent)
}

fn serve(listener: &TcpListener, site: &Arc<Site>, is_over: &AtomicBool, sender: &Sender<(String, Vec<u8>)>) {
    for stream in listener.incoming() {
        if is_over.load(Ordering::Relaxed) {
            return;
        }
        let (site, sender) = (Arc::clone(site), sender.clone());
        // A browser opens connections that it asks nothing on; each has a thread to wait on.
        std::thread::spawn(move || stream.and_then(|stream| answer(stream, &site, &sender)));
    }
}

fn answer(stream: TcpStream, site: &Site, sender: &Sender<(String, Vec<u8>)>) -> std::io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    let mut reader = BufReader::new(stream);
    let mut request = String::new();
    reader.read_line(&mut request)?;
    let mut length = 0;
    loop {
        let mut header = String::new();
        if reader.read_line(&mut header)? <= 2 {
            break;
        }
        if let Some(value) = header.to_ascii_lowercase().strip_prefix("content-length:") {
            length = value.trim().parse().unwrap_or(0);
        }
    }
    let mut body = vec![0; length];
    reader.read_exact(&mut body)?;
    let path = request.split(' ').nth(1).unwrap_or_default();
    let found = match path.strip_prefix("/sent/") {
        Some(name) => {
            let _ = sender.send((name.to_owned(), body));
            Some(Vec::new())
        }
        None => site.find(path),
    };
    let status = if found.is_some() { "200 OK" } else { "404 Not Found" };
    let content = found.unwrap_or_default();
    let mut stream = reader.into_inner();
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {}\r\nContent-Length: {}\r\nConnection: close\r\n\r\n",
        kind(path),
        content.len()
    )?;
    stream.write_all(&content)
}

impl Site {
    fn find(&self, path: &str) -> Option<Vec<u8>> {
        if let Some(text) = self.texts.get(path) {
            return Some(text.clone().into_bytes());
        }
        let inside = |(under, folder): &(&str, PathBuf)| Some(folder.join(path.strip_prefix(under)?));
        self.folders.iter().filter_map(inside).find_map(|file| std::fs::read(file).ok())
    }
}

fn kind(path: &str) -> &'static str {
    match path.rsplit_once('.').map(|(_, extension)| extension) {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("json") => "application/json",
        Some("ico") => "image/x-icon",
        _ => "application/octet-stream",
    }
}
