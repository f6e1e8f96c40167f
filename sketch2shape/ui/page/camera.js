/* A photo of a drawing: from the camera where the page may use it, else through the device's own camera app. */
import { say } from "./words.js";

const $ = id => document.getElementById(id);

/* take(blob) gets the photo, said(words) what went wrong */
export async function photograph(take, said) {
  if (!navigator.mediaDevices?.getUserMedia || matchMedia("(pointer: coarse)").matches) { $("shot").click(); return; }
  let stream;
  try {
    stream = await navigator.mediaDevices.getUserMedia({ video: { facingMode: "environment", width: { ideal: 1920 } } });
  } catch (error) {
    said(say("cameraNone", { why: error.message }));
    return;
  }
  const video = $("camera"), box = $("camera-box");
  video.srcObject = stream;
  box.showModal();
  const shoot = () => {
    const canvas = Object.assign(document.createElement("canvas"), { width: video.videoWidth, height: video.videoHeight });
    canvas.getContext("2d").drawImage(video, 0, 0);
    canvas.toBlob(blob => { if (blob) take(blob); }, "image/jpeg", 0.92);
    box.close();
  };
  $("shoot").addEventListener("click", shoot);
  box.addEventListener("close", () => { $("shoot").removeEventListener("click", shoot); stream.getTracks().forEach(t => t.stop()); video.srcObject = null; }, { once: true });
}
