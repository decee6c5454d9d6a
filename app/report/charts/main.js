// Draws every section. A section that fails does not stop the others.
for (const [id, show] of Object.entries({ verification: showVerification, trade: showTrade, errors: showErrors,
  distance: showDistance, drift: showDrift, stepping: showStepping, scenes: showScenes, claims: showClaims, commands: showCommands })) {
  try {
    show();
  } catch (error) {
    section(id).append(note(`This section could not be drawn: ${error.message}`));
    console.error(error);
  }
}
document.documentElement.dataset.drawn = "yes";
