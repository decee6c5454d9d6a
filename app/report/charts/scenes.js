// The animated scenes: a button that stops them. A picture that stands shows its first frame.

function showScenes() {
  const figures = [...document.querySelectorAll("#scenes .scene")];
  const button = element("button", { type: "button" });
  const pairs = figures.map((figure) => {
    const moving = figure.querySelector("img");
    const still = element("canvas", { width: moving.width, height: moving.height, role: "img",
      "aria-label": moving.alt.replace("Animation: ", "First frame: ") });
    moving.decode().then(() => still.getContext("2d").drawImage(moving, 0, 0, still.width, still.height));
    moving.after(still);
    return { moving, still };
  });
  const show = (plays) => {
    for (const { moving, still } of pairs) [moving.hidden, still.hidden] = [!plays, plays];
    button.textContent = plays ? "Stop the pictures" : "Play the pictures";
    button.onclick = () => show(!plays);
  };
  show(!matchMedia("(prefers-reduced-motion: reduce)").matches);
  document.querySelector("#scenes .scenes").before(element("p", {}, button));
}
