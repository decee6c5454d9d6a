// Everything on the page, in its order. A part that cannot be drawn does not take the others with it.
for (const [id, show] of Object.entries({ verification: showVerification, trade: showTrade, errors: showErrors,
  distance: showDistance, drift: showDrift, stepping: showStepping, claims: showClaims, commands: showCommands })) {
  try {
    show();
  } catch (error) {
    missing(id, `This part could not be drawn: ${error.message}`);
    console.error(error);
  }
}
document.documentElement.dataset.drawn = "yes";
