# picture of friction
