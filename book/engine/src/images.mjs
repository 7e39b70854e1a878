// The memory image after the start, kept by the browser for its next page. Without a place for it
// (a private window, a full disk) each page starts Python anew.
const STORE = "images";

function opened() {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open("workbook-engine", 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE);
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

export async function read(key) {
  try {
    const store = (await opened()).transaction(STORE).objectStore(STORE);
    return await new Promise((resolve, reject) => {
      const request = store.get(key);
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error);
    });
  } catch {
    return undefined;
  }
}

// Keep an image, in place of those of other editions.
export async function keep(key, image) {
  try {
    const store = (await opened()).transaction(STORE, "readwrite").objectStore(STORE);
    store.clear();
    store.put(image, key);
  } catch { /* the next page starts Python anew */ }
}
